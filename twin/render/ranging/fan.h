#pragma once
#include <cmath>

#include "twin/inspection/instrument/look.h"

namespace slackwater::twin {

/// Unit, NED: so far to the right of a pose's axis, and then so far up from the plane of its axis
/// and its right.
[[nodiscard]] inline Triple<double> fan_direction(const Pose& pose, double bearing_rad,
                                                  double elevation_rad) noexcept {
  const Triple<double> down = cross(pose.axis, pose.right);
  return (std::cos(elevation_rad) * std::cos(bearing_rad)) * pose.axis +
         (std::cos(elevation_rad) * std::sin(bearing_rad)) * pose.right -
         std::sin(elevation_rad) * down;
}

/// The middle of a beam, radians to the right of the axis: evenly spaced in angle, the first and
/// the last `across_rad` apart.
[[nodiscard]] inline double beam_bearing_rad(double across_rad, int beams, int beam) noexcept {
  return beams < 2 ? 0 : across_rad * (static_cast<double>(beam) / (beams - 1) - 0.5);
}

}  // namespace slackwater::twin
