#pragma once
#include "fields/base/frame.h"
#include "twin/body/attitude.h"

namespace slackwater::twin {

// The twin is NED in plain triples, the world around it ENU: all that crosses over does so here.

[[nodiscard]] inline Vector3<Enu> enu_of(const Triple<double>& ned) {
  return to_enu(Vector3<Ned>(ned.x, ned.y, ned.z));
}
[[nodiscard]] inline Triple<double> ned_of(const Vector3<Enu>& enu) {
  const Vector3<Ned> ned = to_ned(enu);
  return {ned.x(), ned.y(), ned.z()};
}
/// As the kernels of the sea give it.
[[nodiscard]] inline Triple<double> ned_of(const double (&enu)[3]) {
  return ned_of(Vector3<Enu>(enu[0], enu[1], enu[2]));
}

/// What lies level.
[[nodiscard]] inline Triple<double> ned_of(const Horizontal& level) {
  return {level.imag(), level.real(), 0};
}
/// The level part.
[[nodiscard]] inline Horizontal horizontal_of(const Triple<double>& ned) { return {ned.y, ned.x}; }

/// Above mean sea level.
[[nodiscard]] inline double height_of(const Triple<double>& ned_m) { return -ned_m.z; }

}  // namespace slackwater::twin
