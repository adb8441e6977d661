#include "twin/scenario/read_place.h"

#include "twin/mission/reach.h"

namespace slackwater::twin {
namespace {

/// Depth down or height up, exactly one of them.
double read_down(const Config& config) {
  const auto deep = config.optional_number("depth_m", reached_depth_m);
  const auto high = config.optional_number("height_m", reached_height_m);
  if (deep && high) config.refuse("height_m", "found beside depth_m; give one of the two");
  if (!deep && !high)
    config.refuse("depth_m", "missing; give depth_m below mean sea level, or height_m above it");
  return deep ? *deep : -*high;
}

}  // namespace

Triple<double> read_place(const Config& config) {
  return {config.number("north_m", within_reach_m), config.number("east_m", within_reach_m),
          read_down(config)};
}

AskedSpeed read_speed(const Config& config) {
  constexpr Range speed{0.01, 60};
  const auto own = config.optional_number("speed_m_s", speed);
  const auto over_ground = config.optional_number("ground_speed_m_s", speed);
  if (own && over_ground)
    config.refuse("ground_speed_m_s",
                  "found beside speed_m_s, which AUVs and surface craft keep through the water; "
                  "give one of the two");
  return over_ground ? AskedSpeed{*over_ground, true} : AskedSpeed{own.value_or(0), false};
}

void put_speed(const AskedSpeed& asked, Waypoint& waypoint) noexcept {
  waypoint.speed_m_s = asked.m_s;
  waypoint.over_ground = asked.is_over_ground ? 1 : 0;
}

}  // namespace slackwater::twin
