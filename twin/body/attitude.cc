#include "twin/body/attitude.h"

#include <algorithm>
#include <cmath>

namespace slackwater::twin {

EulerAngles euler_angles(const Attitude<double>& q) noexcept {
  const Rotation<double> r = rotation_of(q);
  return {std::atan2(r.down.y, r.down.z), -std::asin(std::clamp(r.down.x, -1.0, 1.0)),
          std::atan2(r.east.x, r.north.x)};
}

Attitude<double> attitude_of(const EulerAngles& angles) noexcept {
  const double cr = std::cos(angles.roll_rad / 2), sr = std::sin(angles.roll_rad / 2);
  const double cp = std::cos(angles.pitch_rad / 2), sp = std::sin(angles.pitch_rad / 2);
  const double cy = std::cos(angles.yaw_rad / 2), sy = std::sin(angles.yaw_rad / 2);
  return {cr * cp * cy + sr * sp * sy, sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy,
          cr * cp * sy - sr * sp * cy};
}

}  // namespace slackwater::twin
