#include "twin/inspection/surface/read_shape.h"

#include "fields/base/constants.h"
#include "fields/base/text.h"

namespace slackwater::twin {
namespace {

using constants::degree;
constexpr Range from_origin{-1e6, 1e6};

}  // namespace

double read_z(const Config& level) {
  const auto deep = level.optional_number("depth_m", {0, 12000});
  const auto high = level.optional_number("height_m", {0, 500});
  if (deep.has_value() == high.has_value())
    level.refuse("depth_m", "give one of depth_m and height_m");
  return deep ? *deep : -*high;
}

Triple<double> read_point(const Config& config) {
  return {config.number("north_m", from_origin), config.number("east_m", from_origin),
          read_z(config)};
}

Upright read_upright(const Config& config) {
  Upright upright;
  upright.north_m = config.number("north_m", from_origin);
  upright.east_m = config.number("east_m", from_origin);
  upright.top_m = read_z(config.child("from"));
  upright.bottom_m = read_z(config.child("to"));
  if (!(upright.bottom_m > upright.top_m))
    config.refuse("to", formatted("at {:g} m is not below from, at {:g} m (counted downwards); "
                                  "give the upper edge first",
                                  upright.bottom_m, upright.top_m));
  return upright;
}

Arc read_arc(const Config& config) {
  Arc arc{0, 2 * constants::pi};
  if (!config.has("bearings_deg")) return arc;
  const std::vector<double> bearings = config.numbers("bearings_deg", {-360, 720});
  if (bearings.size() != 2)
    config.refuse("bearings_deg", formatted("found {} bearings, expected two: from where to where, "
                                            "clockwise",
                                            bearings.size()));
  const double arc_deg = bearings[1] - bearings[0];
  if (!(arc_deg > 0 && arc_deg <= 360))
    config.refuse("bearings_deg", formatted("goes round by {:g} degrees, expected more than 0 and "
                                            "at most 360; across north write [350, 370]",
                                            arc_deg));
  return {bearings[0] * degree, arc_deg * degree};
}

double number_or(const Config& config, const char* key, double usual, Range range) {
  return config.optional_number(key, range).value_or(usual);
}

}  // namespace slackwater::twin
