#pragma once
#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "twin/control/reference.h"

namespace slackwater::twin {

/// A PID controller as two loops, one inside the other: the error asks for a rate, the rate for an
/// acceleration,
///
///   r_d = outer e,   a = inner (r_d - r) + s,   ds/dt = integral (r_d - r).
///
/// With a natural frequency w and a damping ratio z, outer = w/(2z), inner = 2 z w, integral = z
/// w^2/5: within the range of the limits the PID of Fossen (2011), 12.2.10, k_p = w^2 (and a fifth
/// of z more), k_d = 2 z w, k_i = w^3/10 per unit of mass. In this form the rate can be bounded, a
/// rate can be asked for instead of a place by the same integral (no bump between the two), and the
/// integral does not wind up on a long way, as it sees the error of the rate.
struct Loop {
  double outer_per_s = 0;
  double inner_per_s = 0;
  double integral_per_s2 = 0;
  double most_integral = 0;  ///< m/s2 or rad/s2
};
[[nodiscard]] inline Loop loop_of(double period_s, double damping_ratio,
                                  double most_integral) noexcept {
  const double w = 2 * constants::pi / period_s;
  return {w / (2 * damping_ratio), 2 * damping_ratio * w, 0.2 * damping_ratio * w * w,
          most_integral};
}

[[nodiscard]] inline double acceleration_of(const Loop& loop, double rate_error,
                                            double integral) noexcept {
  return loop.inner_per_s * rate_error + integral;
}

/// Grows the integral, unless what it adds to is already more than the thrusters give (share below
/// 1) and it would ask for more still.
inline void integrate(const Loop& loop, double rate_error, double acceleration, double share,
                      double dt_s, double& integral) noexcept {
  if (share < 1 && rate_error * acceleration > 0) return;
  integral = std::clamp(integral + dt_s * loop.integral_per_s2 * rate_error, -loop.most_integral,
                        loop.most_integral);
}

/// The speed at which to go for a place `away` off: proportional nearby, and from afar no faster
/// than it can be braked with `most_acceleration`. Never negative.
[[nodiscard]] inline double approach_speed(double outer_per_s, double away, double most_speed,
                                           double most_acceleration) noexcept {
  const double bend = most_acceleration / (outer_per_s * outer_per_s);
  const double speed =
      away <= bend ? outer_per_s * away : std::sqrt(most_acceleration * (2 * away - bend));
  return std::min(speed, most_speed);
}

/// From one course to another, rad, positive to the right: 2 tan(e/2) of the angle e, which is e
/// for small ones and grows with it up to pi, without a call of atan2. Straight astern is to the
/// right.
[[nodiscard]] inline double turn_rad(const Course& from, const Course& to) noexcept {
  const double sine = from.north * to.east - from.east * to.north;
  const double cosine = from.north * to.north + from.east * to.east;
  const double size =
      cosine > -0.5 ? std::min(2 * std::abs(sine) / (1 + cosine), constants::pi) : constants::pi;
  return sine < 0 ? -size : size;
}

/// The bow's own course; north for one that points straight up or down.
[[nodiscard]] inline Course bow_of(const Rotation<double>& r) noexcept {
  const double length = std::sqrt(r.north.x * r.north.x + r.east.x * r.east.x);
  return length > 1e-6 ? Course{r.north.x / length, r.east.x / length} : Course{};
}

}  // namespace slackwater::twin
