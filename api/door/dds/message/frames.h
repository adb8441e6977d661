#pragma once
#include "fields/base/frame.h"
#include "twin/body/attitude.h"

namespace slackwater::dds {

// The twin is NED with bodies forward, right, down; ROS (REP-103) is ENU with bodies forward, left,
// up. What turns the one into the other turns it back.

/// A vector over the world.
[[nodiscard]] inline twin::Triple<double> enu_ned(const twin::Triple<double>& v) noexcept {
  return {v.y, v.x, -v.z};
}
/// A vector in body axes.
[[nodiscard]] inline twin::Triple<double> flu_frd(const twin::Triple<double>& v) noexcept {
  return {v.x, -v.y, -v.z};
}
/// Body (forward, right, down) to NED as body (forward, left, up) to ENU, w not negative:
///
///   (0, 1, 1, 0)/sqrt(2) * q * (0, 1, 0, 0)
[[nodiscard]] twin::Attitude<double> enu_flu_ned_frd(const twin::Attitude<double>& q) noexcept;

}  // namespace slackwater::dds
