#pragma once
#include <cmath>

#include "twin/body/attitude.h"

namespace slackwater::twin {

// Attitudes and the turns between them, exact for any angle: a turn is a vector along its axis, as
// long as its angle.

/// p q: first the turn q, then p.
[[nodiscard]] inline Attitude<double> product(const Attitude<double>& p,
                                              const Attitude<double>& q) noexcept {
  return {
      p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z, p.w * q.x + p.x * q.w + p.y * q.z - p.z * q.y,
      p.w * q.y - p.x * q.z + p.y * q.w + p.z * q.x, p.w * q.z + p.x * q.y - p.y * q.x + p.z * q.w};
}

/// The attitude after a turn about an axis of the body. @param turn_rad  body axes
[[nodiscard]] inline Attitude<double> turned(const Attitude<double>& attitude,
                                             const Triple<double>& turn_rad) noexcept {
  const double angle = std::sqrt(dot(turn_rad, turn_rad));
  const double half = 0.5 * angle;
  // sin(x)/x is 1 - x2/6 where its numbers run out.
  const double s = angle > 1e-6 ? std::sin(half) / angle : 0.5 - half * half / 12;
  return normalised(
      product(attitude, {std::cos(half), s * turn_rad.x, s * turn_rad.y, s * turn_rad.z}));
}

/// The turn that leads from one attitude to another, the shorter way. @return body axes, rad
[[nodiscard]] inline Triple<double> turn_between(const Attitude<double>& from,
                                                 const Attitude<double>& to) noexcept {
  const Attitude<double> q = product({from.w, -from.x, -from.y, -from.z}, to);
  const double sine = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z);
  const double sign = q.w < 0 ? -1 : 1;
  const double per_sine = sine > 1e-9 ? 2 * std::atan2(sine, sign * q.w) / sine : 2;
  return (sign * per_sine) * Triple<double>{q.x, q.y, q.z};
}

}  // namespace slackwater::twin
