#include "twin/search/leeway.h"

#include <cmath>

#include "twin/curve/named_file.h"

namespace slackwater::twin {
namespace {

LeewayLine read_line(const Config& config, std::string_view key) {
  const Config c = config.child(key);
  LeewayLine line;
  // The fastest of the tested classes drifts at 7.4 % of the wind.
  line.slope = c.number("slope_percent", {-15, 15}) / 100;
  line.offset_m_s = c.number("offset_cm_s", {-50, 50}) / 100;
  line.std_m_s = c.number("std_cm_s", {0, 50}) / 100;
  return line;
}

DrawnLine drawn_line(const LeewayLine& line, double deviation) noexcept {
  constexpr double slope_per_m_s = 1.0 / 20, share_of_offset = 0.5;
  return {line.slope + deviation * line.std_m_s * slope_per_m_s,
          line.offset_m_s + deviation * line.std_m_s * share_of_offset};
}

}  // namespace

LeewayObject read_leeway(const std::string& name, const std::filesystem::path& data_folder) {
  const Config c = open_named(name, "search: object", data_folder / "leeway");
  LeewayObject object;
  object.name = c.text("name");
  (void)c.text("source");
  (void)c.text("status");
  object.seen_as = c.text("seen_as");
  object.downwind = read_line(c, "downwind");
  object.right = read_line(c, "crosswind_right");
  object.left = read_line(c, "crosswind_left");
  if (object.downwind.slope < 0)
    c.refuse("downwind", "found a negative slope; nothing drifts faster into a stronger wind");
  if (const auto percent = c.optional_number("jibe_percent_per_h", {0, 100}))
    object.jibe_rate_per_s = *percent / 100 / 3600;
  c.expect_all_read();
  return object;
}

LeewayDraw mean_leeway(const LeewayObject& object) noexcept {
  return {drawn_line(object.downwind, 0), drawn_line(object.right, 0), drawn_line(object.left, 0)};
}

LeewayDraw draw_leeway(const LeewayObject& object, Rng& rng) {
  LeewayDraw drawn;
  do {
    drawn.downwind = drawn_line(object.downwind, rng.normal());
  } while (drawn.downwind.slope < 0);
  const double outwards = rng.normal();
  drawn.right = drawn_line(object.right, outwards);
  drawn.left = drawn_line(object.left, -outwards);
  return drawn;
}

Triple<double> leeway_velocity(const LeewayDraw& drawn, bool is_left,
                               const Triple<double>& wind_10m_m_s) noexcept {
  const double wind_m_s = std::hypot(wind_10m_m_s.x, wind_10m_m_s.y);
  if (wind_m_s == 0) return {};
  const auto speed = [&](const DrawnLine& line) { return line.slope * wind_m_s + line.offset_m_s; };
  const double north = wind_10m_m_s.x / wind_m_s, east = wind_10m_m_s.y / wind_m_s;
  const double down = speed(drawn.downwind), right = speed(is_left ? drawn.left : drawn.right);
  return {down * north - right * east, down * east + right * north, 0};
}

}  // namespace slackwater::twin
