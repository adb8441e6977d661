#pragma once
#include "fields/base/numbers/real.h"

namespace slackwater::twin {

// Momentum theory of a propeller: a disc of area A that pushes with T on fluid that comes at Va
// induces w in it,
//
//   T = 2 rho A w (Va + w),   P = T (Va + w),
//
// with Va counted along the thrust (what comes at the disc from ahead is positive). `disc_kg_m` is
// 2 rho A.
// Source: Carlton, Marine Propellers and Propulsion (4th ed., 2019), 8.2; Leishman, Helicopter
// Aerodynamics (2006), 2.

/// +1 or, for what is negative, -1.
template <typename Real>
[[nodiscard]] Real way_of(const Real& value) {
  return select(value < 0.0, Real{} - 1.0, Real{} + 1.0);
}

/// Where momentum theory is left for flow against the thrust: at half the induced velocity of rest
/// (beyond it rings of vortices form, and no simple theory holds).
inline constexpr double most_backflow = 0.5;

/// z = (Va + w)/w0 of a disc that has the power 2 rho A w0^3, at k = Va/w0: the root of
/// z^3 - k z^2 = 1. Its thrust is 1/z of that at rest.
///
/// By Householder's method of the third order, f the cubic less 1,
///
///   z -> z - f (f'^2 - f f''/2)/(f'^3 - f f' f'' + f^2),   f''' = 6,
///
/// from z^2 - k z = 1 (the disc that keeps its thrust): two steps, of a division each, give all
/// digits for any k. Held at k = -1/2, where the thrust is 17 % above that at rest.
template <typename Real>
[[nodiscard]] Real flow_through_disc(const Real& k_of_any_size) {
  const Real k = larger_of(k_of_any_size, Real{} - most_backflow);
  Real z = 0.5 * k + square_root(0.25 * (k * k) + 1.0);
  for (int i = 0; i < 2; ++i) {
    const Real f = z * z * (z - k) - 1.0;
    const Real slope = z * (3.0 * z - 2.0 * k);
    const Real bent = f * (6.0 * z - 2.0 * k);
    const Real slope2 = slope * slope;
    z = z - f * (slope2 - 0.5 * bent) / (slope * (slope2 - bent) + f * f);
  }
  return z;
}

/// Thrust in flow of a disc that keeps the hydraulic power it has at rest, where it pushes with
/// `rest_n`.
template <typename Real>
[[nodiscard]] Real thrust_in_flow(double disc_kg_m, const Real& rest_n, const Real& advance_m_s) {
  // Without thrust nothing is divided by nothing.
  const Real induced_m_s =
      larger_of(square_root(absolute(rest_n) * (1 / disc_kg_m)), Real{} + 1e-6);
  return rest_n / flow_through_disc(Real{way_of(rest_n) * advance_m_s / induced_m_s});
}

/// Power of a loss-free disc. What comes from behind gives none back.
template <typename Real>
[[nodiscard]] Real disc_power_w(double disc_kg_m, const Real& thrust_n, const Real& advance_m_s) {
  const Real half = 0.5 * larger_of(Real{way_of(thrust_n) * advance_m_s}, Real{} + 0.0);
  const Real size_n = absolute(thrust_n);
  return size_n * (half + square_root(half * half + size_n * (1 / disc_kg_m)));
}

/// Thrust at rest of a disc that pushes with `thrust_n` in flow: undoes `thrust_in_flow`.
[[nodiscard]] double rest_thrust_n(double disc_kg_m, double thrust_n, double advance_m_s);

}  // namespace slackwater::twin
