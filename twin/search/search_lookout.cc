#include "twin/search/search_lookout.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/curve/named_file.h"

namespace slackwater::twin {
namespace {

DetectionLaw read_law(const Config& c) {
  const std::string law = c.text("law");
  if (law == "inverse_cube") return DetectionLaw::inverse_cube;
  if (law == "definite_range") return DetectionLaw::definite_range;
  c.refuse("law", "found " + law + ", expected inverse_cube or definite_range");
}

void read_widths(const Config& c, std::string_view seen_as, SearchLookout& lookout) {
  lookout.visibility_m = c.numbers("visibility_m", {1, 1e5});
  if (lookout.visibility_m.empty() ||
      std::adjacent_find(lookout.visibility_m.begin(), lookout.visibility_m.end(),
                         std::greater_equal<>()) != lookout.visibility_m.end())
    c.refuse("visibility_m", "give the visibilities in rising order");
  const Config widths = c.child("sweep_width_m");
  const std::vector<std::string> objects = widths.keys();
  for (const std::string& object : objects) {
    const std::vector<double> width_m = widths.numbers(object, {0, 1e5});
    if (width_m.size() != lookout.visibility_m.size())
      widths.refuse(object, formatted("found {} widths for {} visibilities", width_m.size(),
                                      lookout.visibility_m.size()));
    if (!std::is_sorted(width_m.begin(), width_m.end()))
      widths.refuse(object,
                    "found a greater width in worse visibility; expected it not to grow as the "
                    "visibility falls");
    if (object == seen_as) lookout.width_m = width_m;
  }
  if (lookout.width_m.empty())
    c.refuse("sweep_width_m", "has nothing for what is looked for, " + std::string(seen_as) +
                                  "; it has " + joined(objects, ", "));
}

void read_weather(const Config& c, SearchLookout& lookout) {
  constexpr double any = std::numeric_limits<double>::infinity();
  for (const Config& entry : c.children("weather")) {
    const SearchLookout::Weather weather{
        entry.optional_number("wind_up_to_m_s", {0, 100}).value_or(any),
        entry.optional_number("waves_up_to_m", {0, 30}).value_or(any),
        entry.number("factor", {0, 1})};
    if (!lookout.weather.empty()) {
      const SearchLookout::Weather& before = lookout.weather.back();
      if (weather.factor > before.factor)
        entry.refuse("factor",
                     "found a greater factor in rougher weather; expected it not to grow");
      if (weather.most_wind_m_s < before.most_wind_m_s ||
          weather.most_wave_height_m < before.most_wave_height_m)
        entry.refuse("factor", "give the weather in rising order of wind and waves");
    }
    lookout.weather.push_back(weather);
  }
  if (lookout.weather.empty() || lookout.weather.back().most_wind_m_s != any ||
      lookout.weather.back().most_wave_height_m != any)
    c.refuse("weather", "end it with a factor for all rougher weather, without bounds");
}

/// ds/r^3 from s = 0 to `s_m`, at lateral range x.
double from_abeam(double x_m, double s_m) noexcept {
  return s_m > 0 ? s_m / (x_m * x_m * std::hypot(x_m, s_m)) : 0;
}

/// The integral of ds/r^3 from a to b: without the difference of two like numbers where both lie on
/// one side of abeam.
double inverse_cube_way(double x_m, double a_m, double b_m) noexcept {
  if (a_m < 0 && b_m > 0) return from_abeam(x_m, -a_m) + from_abeam(x_m, b_m);
  double near = std::min(std::abs(a_m), std::abs(b_m)),
         far = std::max(std::abs(a_m), std::abs(b_m));
  const double r1 = std::hypot(x_m, near), r2 = std::hypot(x_m, far);
  return (far * far - near * near) / (r1 * r2 * (far * r1 + near * r2));
}

}  // namespace

SearchLookout read_search_lookout(const std::string& name, std::string_view seen_as,
                                  const std::filesystem::path& data_folder) {
  const Config c = open_named(name, "search: lookout", data_folder / "lookouts");
  SearchLookout lookout;
  lookout.name = c.text("name");
  (void)c.text("source");
  (void)c.text("status");
  lookout.law = read_law(c);
  read_widths(c, seen_as, lookout);
  read_weather(c, lookout);
  c.expect_all_read();
  return lookout;
}

double sweep_width_m(const SearchLookout& lookout, const SightConditions& sight) noexcept {
  double width_m = lookout.width_m.back();
  double below_m = 0, width_below_m = 0;
  for (std::size_t i = 0; i < lookout.visibility_m.size(); ++i) {
    if (sight.visibility_m < lookout.visibility_m[i]) {
      const double share = (sight.visibility_m - below_m) / (lookout.visibility_m[i] - below_m);
      width_m = width_below_m + share * (lookout.width_m[i] - width_below_m);
      break;
    }
    below_m = lookout.visibility_m[i];
    width_below_m = lookout.width_m[i];
  }
  for (const SearchLookout::Weather& weather : lookout.weather)
    if (sight.wind_10m_m_s <= weather.most_wind_m_s &&
        sight.wave_height_m <= weather.most_wave_height_m)
      return weather.factor * width_m;
  return 0;
}

double look_exposure(DetectionLaw law, double width_m, const Triple<double>& from_m,
                     const Triple<double>& to_m, double dt_s) noexcept {
  constexpr double slowest_m_s = 0.5, nowhere_m = 1e-9;
  if (!(width_m > 0)) return 0;
  const double north = to_m.x - from_m.x, east = to_m.y - from_m.y;
  const double way_m = std::hypot(north, east);
  const double begin_m = std::hypot(from_m.x, from_m.y);
  // In the plane turned along the way: abeam at 0.
  const bool stays = way_m < nowhere_m;
  const double a_m = stays ? 0 : (from_m.x * north + from_m.y * east) / way_m;
  const double x_m = stays ? begin_m : std::abs(from_m.x * east - from_m.y * north) / way_m;
  if (law == DetectionLaw::definite_range) {
    const double off_m = std::max({a_m, -(a_m + way_m), 0.0});
    return std::hypot(x_m, off_m) <= 0.5 * width_m ? std::numeric_limits<double>::infinity() : 0;
  }
  const double strength_m2 = width_m * width_m / (8 * constants::pi);
  if (stays) return strength_m2 * slowest_m_s * dt_s / (begin_m * begin_m * begin_m);
  return strength_m2 * inverse_cube_way(x_m, a_m, a_m + way_m) *
         std::max(1.0, slowest_m_s * dt_s / way_m);
}

bool detected(double exposure, Rng& rng) noexcept { return rng.uniform() < -std::expm1(-exposure); }

}  // namespace slackwater::twin
