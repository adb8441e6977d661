#pragma once
#include "fields/base/constants.h"
#include "twin/body/body.h"
#include "twin/body/lift_and_cross_flow.h"

namespace slackwater::twin {

/// The share of the hull that is under water: 1 below the surface, linear over the height of the
/// hull.
template <typename Real>
[[nodiscard]] Real immersed_share(const Body& body, const Real& depth_m, const Real& elevation_m) {
  const Real share = (depth_m + elevation_m) / body.height_m + 0.5;
  return smaller_of(larger_of(share, Real{} + 0.0), Real{} + 1.0);
}

/// Force of the fluid against motion through it, about the body's origin.
///
/// Linear on the velocity at the origin; quadratic station by station, each in the water of its own
/// depth, so that shear over the hull turns it. Without shear the stations add up to the published
/// coefficients.
template <typename Real>
[[nodiscard]] Spatial<Real> damping(const Body& body, const Rotation<Real>& r,
                                    const Spatial<Real>& nu_r, const Triple<Real>& shear_per_s) {
  const auto quadratic = [](double coefficient, const Real& speed) -> Real {
    return coefficient * (absolute(speed) * speed);
  };
  const Spatial<double>& l = body.linear_damping;
  const Spatial<double>& q = body.quadratic_damping;
  Spatial<Real> drag{
      {l.linear.x * nu_r.linear.x, l.linear.y * nu_r.linear.y, l.linear.z * nu_r.linear.z},
      {l.angular.x * nu_r.angular.x + quadratic(q.angular.x, nu_r.angular.x),
       l.angular.y * nu_r.angular.y + quadratic(q.angular.y, nu_r.angular.y),
       l.angular.z * nu_r.angular.z + quadratic(q.angular.z, nu_r.angular.z)}};
  const double share = 1.0 / static_cast<double>(body.stations);
  const Triple<Real> shear = r.to_body(shear_per_s);
  for (std::size_t i = 0; i < body.stations; ++i) {
    const Triple<double>& at = body.station_m[i];
    const Real deeper_m = r.down.x * at.x + r.down.y * at.y + r.down.z * at.z;
    const Triple<Real> met = nu_r.linear - deeper_m * shear;
    const Triple<Real> force{quadratic(share * q.linear.x, met.x),
                             quadratic(share * q.linear.y, met.y),
                             quadratic(share * q.linear.z, met.z)};
    drag.linear = drag.linear + force;
    drag.angular = drag.angular + Triple<Real>{at.y * force.z - at.z * force.y,
                                               at.z * force.x - at.x * force.z,
                                               at.x * force.y - at.y * force.x};
  }
  return drag;
}

/// What keeps a hull on its course: the sideways momentum a (v + x r) that it gives the water
/// slides off its trailing edge with the speed of the hull,
///
///   Y = -a |u| (v + x r),  N = x Y
///
/// against half of the moment of its added mass (Munk), which turns every slender body across its
/// way. The edge is at the other end of a craft that goes astern. Source: Lighthill (1960); Newman,
/// Marine Hydrodynamics (1977), ch. 7.
template <typename Real>
[[nodiscard]] Spatial<Real> lift_of_hull(const Body& body, const Spatial<Real>& nu_r) {
  const double x = body.trailing_edge_x_m;
  const Real at_m = select(nu_r.linear.x < 0.0, Real{} - x, Real{} + x);
  const Real aside_m_s = nu_r.linear.y + at_m * nu_r.angular.z;
  const Real force = -(body.trailing_edge_kg_m * (absolute(nu_r.linear.x) * aside_m_s));
  return {{Real{}, force, Real{}}, {Real{}, Real{}, at_m * force}};
}

/// Weight and buoyancy, Fossen (2011) 4.1: -g(eta). `extra_volume_m3` and `gravity_shift_m` are
/// those of a buoyancy engine and of a mass that moves along x.
template <typename Real>
[[nodiscard]] Spatial<Real> restoring(const Body& body, const Rotation<Real>& r,
                                      const Real& immersed, const Real& extra_volume_m3,
                                      const Real& gravity_shift_m) {
  const Real weight_n = Real{} + body.mass_kg * constants::gravity_m_s2;
  const Real buoyancy_n = (body.fluid_density_kg_m3 * constants::gravity_m_s2) *
                          (immersed * (body.displaced_volume_m3 + extra_volume_m3));
  const Triple<double>& g = body.centre_of_gravity_m;
  const Triple<double>& b = body.centre_of_buoyancy_m;
  const Triple<Real> gravity_at{g.x + gravity_shift_m, Real{} + g.y, Real{} + g.z};
  const Triple<Real> buoyancy_at{Real{} + b.x, Real{} + b.y, Real{} + b.z};
  return force_at(gravity_at, weight_n * r.down) - force_at(buoyancy_at, buoyancy_n * r.down);
}

/// What acts on a body during one step beside the water's resistance: body axes, about the origin.
template <typename Real>
struct Forcing {
  Spatial<Real> tau;  ///< thrusters, fins, wind, tether
  /// For a surface craft the current alone, without the waves: it meets these at its strips.
  FluidMotion<Real> fluid;
  WavesMet<Real> waves;
  Real extra_volume_m3{};
  Real gravity_shift_m{};
};

/// The water that a body meets, as a rigid motion in body axes about its origin.
template <typename Real>
struct WaterMet {
  Spatial<Real> velocity;
  Spatial<Real> acceleration;
};

template <typename Real>
[[nodiscard]] WaterMet<Real> water_met(const Body& body, const Rotation<Real>& r,
                                       const Forcing<Real>& forcing) {
  const Spatial<Real> current{r.to_body(forcing.fluid.velocity_m_s), {}};
  const Spatial<Real> its_change{r.to_body(forcing.fluid.acceleration_m_s2), {}};
  if (body.hull.strips == 0) return {current, its_change};
  return {current + motion_of_strips(body.hull, r, forcing.waves.velocity),
          its_change + motion_of_strips(body.hull, r, forcing.waves.acceleration)};
}

/// d nu/dt by Fossen's equations in moving water,
///
///   M_RB nu' + C_RB(nu) nu + M_A nu_r' + C_A(nu_r) nu_r + D(nu_r) nu_r + g(eta)
///     = tau + rho V R^T Du/Dt
///
/// with nu_r = nu - (R^T U, 0), so that (R^T U)' = R^T Du/Dt - w x R^T U. The last term is what the
/// pressure that accelerates the water does to the body in its place (Froude-Krylov; Auton, Hunt
/// and Prud'homme 1988).
/// Source: Fossen (2011), 6.1-6.3 and 8.3.
template <typename Real>
[[nodiscard]] Spatial<Real> acceleration(const Body& body, const BodyState<Real>& state,
                                         const Forcing<Real>& forcing) {
  const Rotation<Real> r = rotation_of(state.attitude);
  const WaterMet<Real> water = water_met(body, r, forcing);
  const Spatial<Real> nu_r = state.nu - water.velocity;
  const Real immersed = immersed_share(body, state.position_m.z, forcing.fluid.elevation_m);
  const Triple<Real> displaced_mass_force =
      (body.fluid_density_kg_m3 * body.displaced_volume_m3 * immersed) * water.acceleration.linear;
  const Triple<double>& b = body.centre_of_buoyancy_m;
  const Spatial<Real> froude_krylov =
      force_at(Triple<Real>{Real{} + b.x, Real{} + b.y, Real{} + b.z}, displaced_mass_force);
  const Spatial<Real> carried =
      body.added_mass *
      Spatial<Real>{water.acceleration.linear - cross(state.nu.angular, water.velocity.linear),
                    water.acceleration.angular};
  Spatial<Real> force =
      forcing.tau + froude_krylov + carried + lift_of_hull(body, nu_r) -
      coriolis(body.rigid_mass, state.nu) - coriolis(body.added_mass, nu_r) -
      damping(body, r, nu_r, forcing.fluid.shear_per_s) +
      restoring(body, r, immersed, forcing.extra_volume_m3, forcing.gravity_shift_m);
  if (body.hull.strips > 0) {
    force = force + floating_force(body.hull, body.fluid_density_kg_m3, r, state.position_m.z,
                                   forcing.waves.at_strips);
  }
  if (body.has_more())
    force = force + lift_and_cross_flow(body, r, nu_r, forcing.fluid.shear_per_s);
  return body.inverse_mass * force;
}

template <typename Real>
struct BodyRate {
  Triple<Real> position_m_s;
  Attitude<Real> attitude;
  Spatial<Real> nu;
};

template <typename Real>
[[nodiscard]] BodyRate<Real> rate_of(const Body& body, const BodyState<Real>& state,
                                     const Forcing<Real>& forcing) {
  return {rotation_of(state.attitude).to_ned(state.nu.linear),
          rate_of(state.attitude, state.nu.angular), acceleration(body, state, forcing)};
}

template <typename Real>
[[nodiscard]] BodyState<Real> moved(const BodyState<Real>& s, const BodyRate<Real>& rate,
                                    double dt_s) {
  const auto grown = [&](const Real& value, const Real& slope) -> Real {
    return value + dt_s * slope;
  };
  const auto triple = [&](const Triple<Real>& a, const Triple<Real>& b) -> Triple<Real> {
    return {grown(a.x, b.x), grown(a.y, b.y), grown(a.z, b.z)};
  };
  return {triple(s.position_m, rate.position_m_s),
          {grown(s.attitude.w, rate.attitude.w), grown(s.attitude.x, rate.attitude.x),
           grown(s.attitude.y, rate.attitude.y), grown(s.attitude.z, rate.attitude.z)},
          {triple(s.nu.linear, rate.nu.linear), triple(s.nu.angular, rate.nu.angular)}};
}

/// One step of the classical Runge-Kutta method under constant forcing; fourth order.
template <typename Real>
[[nodiscard]] BodyState<Real> stepped(const Body& body, const BodyState<Real>& s,
                                      const Forcing<Real>& forcing, double dt_s) {
  const double reach_s[] = {0.5 * dt_s, 0.5 * dt_s, dt_s};
  const double weight_s[] = {dt_s / 6, dt_s / 3, dt_s / 3, dt_s / 6};
  BodyState<Real> next = s;
  BodyState<Real> at = s;
  for (std::size_t i = 0; i < 4; ++i) {
    const BodyRate<Real> rate = rate_of(body, at, forcing);
    next = moved(next, rate, weight_s[i]);
    if (i < 3) at = moved(s, rate, reach_s[i]);
  }
  next.attitude = normalised(next.attitude);
  return next;
}

}  // namespace slackwater::twin
