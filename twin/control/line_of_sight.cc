#include "twin/control/line_of_sight.h"

#include <algorithm>
#include <cmath>

#include "fields/base/turn.h"

namespace slackwater::twin {

Heading heading_along(const LineOfSight& guidance, const Triple<double>& from, const Waypoint& to,
                      const Triple<double>& position_m, const Triple<double>& water_m_s,
                      double speed_m_s) noexcept {
  const LegPlace place = place_on_leg(from, to.position_m, position_m);
  const double course =
      bearing_rad(place.course) - std::atan2(place.across_m, guidance.lookahead_m);
  Heading heading;
  heading.speed_m_s = to.speed_m_s > 0 ? to.speed_m_s : speed_m_s;
  heading.yaw_rad = course;
  if (guidance.compensates_current && heading.speed_m_s > 0) {
    const double across = -std::sin(course) * water_m_s.x + std::cos(course) * water_m_s.y;
    heading.yaw_rad = course - std::asin(std::clamp(across / heading.speed_m_s, -1.0, 1.0));
  }
  heading.yaw_rad = wrapped_rad(heading.yaw_rad);
  // Down the leg as far as the vehicle has come.
  const double share =
      place.length_m > 0 ? std::clamp(place.along_m / place.length_m, 0.0, 1.0) : 1.0;
  heading.depth_m = from.z + share * (to.position_m.z - from.z);
  return heading;
}

}  // namespace slackwater::twin
