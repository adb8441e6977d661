#pragma once
#include "twin/body/attitude.h"
#include "twin/body/body.h"

namespace slackwater::twin {

/// Lift of body and fixed fins with the speed ahead, about the origin,
///
///   Y = s (Y_uv v + Y_ur r)    N = s (N_uv v + N_ur r)    K = s K_up p
///   Z = s (Z_uw w + Z_uq q)    M = s (M_uw w + M_uq q)    s = |u|
///
/// The derivatives are published for a vehicle that goes ahead; astern this is an estimate.
/// Source: SNAME T&R 1-5 (1950); Prestero (2001), 4.3-4.5.
template <typename Real>
[[nodiscard]] Spatial<Real> lift_with_speed(const SpeedLift& lift, const Spatial<Real>& nu_r) {
  const Real speed = absolute(nu_r.linear.x);
  const Real v = speed * nu_r.linear.y, w = speed * nu_r.linear.z;
  const Real p = speed * nu_r.angular.x, q = speed * nu_r.angular.y, r = speed * nu_r.angular.z;
  return {{Real{}, lift.y_uv * v + lift.y_ur * r, lift.z_uw * w + lift.z_uq * q},
          {lift.k_up * p, lift.m_uw * w + lift.m_uq * q, lift.n_uv * v + lift.n_ur * r}};
}

/// What takes off of -C_A nu_r the moments by which the added mass turns a body across its way
/// (Munk) and their counterparts in the forces: with (a, b, c) the linear part of M_A nu_r,
///
///   X += q c - r b,  Y += r a,  Z -= q a,  M += w a - u c,  N += u b - v a
///
/// It does no work, as C_A does none.
template <typename Real>
[[nodiscard]] Spatial<Real> munk_taken_off(const SpatialMatrix& added_mass,
                                           const Spatial<Real>& nu_r) {
  const Triple<Real> carried = (added_mass * nu_r).linear;
  const Triple<Real>& v = nu_r.linear;
  const Real& q = nu_r.angular.y;
  const Real& r = nu_r.angular.z;
  return {{q * carried.z - r * carried.y, r * carried.x, -(q * carried.x)},
          {Real{}, v.z * carried.x - v.x * carried.z, v.x * carried.y - v.y * carried.x}};
}

/// Drag of the cross-flow, about the origin: with c = v + x r and e = w - x q,
///
///   Y = -rho/2 int C_d T c |c| dx,  N = int x dY,  Z = -rho/2 int C_d B e |e| dx,  M = -int x dZ
///
/// by the midpoint rule, each strip in the water of its own depth. Source: Fossen (2021), 6.4.3;
/// Faltinsen (1990), ch. 6.
template <typename Real>
[[nodiscard]] Spatial<Real> drag_of_cross_flow(const CrossFlow& flow, const Rotation<Real>& r,
                                               const Spatial<Real>& nu_r,
                                               const Triple<Real>& shear_per_s) {
  const Triple<Real> shear = r.to_body(shear_per_s);
  Spatial<Real> sum{};
  for (std::size_t i = 0; i < flow.strips; ++i) {
    const double x = flow.x_m[i];
    const Real deeper_m = x * r.down.x;
    const Real aside = nu_r.linear.y - deeper_m * shear.y + x * nu_r.angular.z;
    const Real below = nu_r.linear.z - deeper_m * shear.z - x * nu_r.angular.y;
    const Real sway = flow.sway_n_s2_m2[i] * (absolute(aside) * aside);
    const Real heave = flow.heave_n_s2_m2[i] * (absolute(below) * below);
    sum.linear.y = sum.linear.y - sway;
    sum.linear.z = sum.linear.z - heave;
    sum.angular.y = sum.angular.y + x * heave;
    sum.angular.z = sum.angular.z - x * sway;
  }
  return sum;
}

/// -D nu_r off the diagonal, with the four quadratic terms that published tables have there.
template <typename Real>
[[nodiscard]] Spatial<Real> force_of_cross_damping(const CrossDamping& damping,
                                                   const Spatial<Real>& nu_r) {
  const Spatial<Real> linear = damping.linear * nu_r;
  const auto squared = [](const Real& a) -> Real { return absolute(a) * a; };
  const Real v = squared(nu_r.linear.y), w = squared(nu_r.linear.z);
  const Real q = squared(nu_r.angular.y), r = squared(nu_r.angular.z);
  const Spatial<Real> quadratic{{Real{}, damping.y_r * r, damping.z_q * q},
                                {Real{}, damping.m_w * w, damping.n_v * v}};
  return Spatial<Real>{} - (linear + quadratic);
}

/// What a body with one of these feels beside what all bodies do, about the origin.
/// Called for those alone, and never made part of its caller: the registers of everybody's step are
/// full. All that it calls is made part of it, so that the code of one instruction set stays there.
template <typename Real>
[[gnu::noinline, gnu::flatten]] Spatial<Real> lift_and_cross_flow(const Body& body,
                                                                  const Rotation<Real>& r,
                                                                  const Spatial<Real>& nu_r,
                                                                  const Triple<Real>& shear_per_s) {
  Spatial<Real> sum{};
  if (body.speed_lift.is_there) {
    sum = sum + lift_with_speed(body.speed_lift, nu_r);
    if (body.speed_lift.without_munk) sum = sum + munk_taken_off(body.added_mass, nu_r);
  }
  if (body.cross_damping.is_there) sum = sum + force_of_cross_damping(body.cross_damping, nu_r);
  if (body.cross_flow.is_there)
    sum = sum + drag_of_cross_flow(body.cross_flow, r, nu_r, shear_per_s);
  return sum;
}

/// What a body resists in pure motion along or about each axis, per square of its rate: the
/// diagonal with the strips of its cross-flow.
[[nodiscard]] Spatial<double> resistance_along_axes(const Body& body);

}  // namespace slackwater::twin
