#pragma once
#include <cmath>
#include <limits>

#include "fields/base/constants.h"
#include "fields/base/yaml_value.h"
#include "twin/body/attitude.h"

// Only sources of this folder include this.

namespace slackwater::twin {

/// The number of a file that a reader makes `value` of: a short one if there is one, else of those
/// next to its reckoning the one that comes back to the bit.
/// @param near  the reckoning
/// @param read  what the reader makes of a number
template <typename Read>
[[nodiscard]] double number_for(double value, double near, const Read& read) {
  const double brief = std::round(near * 1e6) / 1e6 + 0.0;
  if (read(brief) == value) return brief;
  double below = near, above = near;
  for (int i = 0; i < 8; ++i) {
    if (read(below) == value) return below;
    if (read(above) == value) return above;
    below = std::nextafter(below, -std::numeric_limits<double>::infinity());
    above = std::nextafter(above, std::numeric_limits<double>::infinity());
  }
  return near;
}

/// Of an angle that a reader multiplies by pi/180.
[[nodiscard]] inline double degrees_for(double rad) {
  using constants::degree;
  return number_for(rad, rad / degree, [](double deg) { return deg * degree; });
}
/// Of what a reader multiplies by that.
[[nodiscard]] inline double multiple_for(double value, double of) {
  return number_for(value, value / of, [of](double number) { return of * number; });
}

/// Puts depth_m, or height_m of what is above the sea.
inline void put_level(double down_m, YamlValue& value) {
  if (down_m < 0)
    value.put("height_m", -down_m);
  else
    value.put("depth_m", down_m);
}
/// {depth_m: 5} or {height_m: 12}.
[[nodiscard]] inline YamlValue level_value(double down_m) {
  YamlValue value;
  put_level(down_m, value);
  return value;
}
/// {north_m, east_m}.
[[nodiscard]] inline YamlValue plan_value(const Triple<double>& at_m) {
  YamlValue value;
  value.put("north_m", at_m.x).put("east_m", at_m.y);
  return value;
}
/// {north_m, east_m, depth_m or height_m}.
[[nodiscard]] inline YamlValue place_value(const Triple<double>& at_m) {
  YamlValue value = plan_value(at_m);
  put_level(at_m.z, value);
  return value;
}
/// [FROM, TO], clockwise, of a reader that multiplies FROM and TO - FROM by pi/180. Of the bearings
/// that are the first angle, the one that the arc comes back from.
[[nodiscard]] inline YamlValue bearings_value(double from_rad, double arc_rad) {
  using constants::degree;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const double near_deg = degrees_for(from_rad);
  double from_deg = near_deg, to_deg = 0;
  for (const double first_deg :
       {near_deg, std::nextafter(near_deg, -infinite), std::nextafter(near_deg, infinite)}) {
    if (first_deg * degree != from_rad) continue;
    const auto arc_to = [&](double bearing_deg) { return (bearing_deg - first_deg) * degree; };
    from_deg = first_deg;
    to_deg = number_for(arc_rad, first_deg + arc_rad / degree, arc_to);
    if (arc_to(to_deg) == arc_rad) break;
  }
  return YamlValue::numbers({from_deg, to_deg});
}
/// {forward_m, starboard_m, up_m}.
[[nodiscard]] inline YamlValue on_board_value(const Triple<double>& at_m) {
  YamlValue value;
  value.put("forward_m", at_m.x).put("starboard_m", at_m.y).put("up_m", -at_m.z + 0.0);
  return value;
}

}  // namespace slackwater::twin
