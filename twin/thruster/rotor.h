#pragma once
#include "twin/thruster/actuator_disc.h"
#include "twin/thruster/surroundings.h"

namespace slackwater::twin {

/// A rotor of a multirotor, commanded by its speed in rad/s.
struct Rotor {
  double thrust_n_s2 = 0;   ///< T = k w^2
  double torque_arm_m = 0;  ///< Q = c T
  double disc_kg_m = 0;     ///< 2 rho A
  double radius_m = 0;
  double efficiency =
      0;  ///< induced power over electrical power: figure of merit, motor, controller
  double drag_n_s2_m = 0;  ///< force against edgewise motion per speed and rad/s
  double most_rad_s = 0;
  double full_speed_voltage_v = 0;  ///< of the bus, from which on it turns that fast; 0: always
};

/// Induced velocity of a rotor that climbs and moves edgewise (Glauert): v = vh^2/sqrt(V^2 + (Vc +
/// v)^2).
///
/// Newton's method from the smaller of the closed forms for either motion alone, between which the
/// root lies; within 1e-6 of itself after three steps.
/// @param hover2 square of the induced velocity in hover, above 0
/// Source: Leishman, Helicopter Aerodynamics (2006), 2.14.
template <typename Real>
[[nodiscard]] Real induced_velocity_m_s(const Real& hover2, const Real& climb_m_s,
                                        const Real& edgewise2) {
  const Real half_climb = 0.5 * climb_m_s;
  const Real half_edgewise2 = 0.5 * edgewise2;
  const Real climbs = hover2 / (half_climb + square_root(half_climb * half_climb + hover2));
  const Real moves =
      hover2 /
      square_root(half_edgewise2 + square_root(half_edgewise2 * half_edgewise2 + hover2 * hover2));
  Real v = smaller_of(climbs, moves);
  for (int i = 0; i < 3; ++i) {
    const Real through = climb_m_s + v;
    const Real flow2 = edgewise2 + through * through;
    const Real flow = square_root(flow2);
    v = v - flow * (v * flow - hover2) / (flow2 + v * through);
  }
  return v;
}

/// Thrust over that far from the ground, at the same power: 1/(1 - (R/4z)^2/(1 + (V/v)^2)), held at
/// z = R/2.
/// Source: Cheeseman & Bennett (1955), The effect of the ground on a helicopter rotor in forward
/// flight, ARC R&M 3021.
template <typename Real>
[[nodiscard]] Real ground_effect(double radius_m, const Real& height_m, const Real& edgewise2,
                                 const Real& induced_m_s) {
  const Real near = (0.25 * radius_m) / larger_of(height_m, Real{} + 0.5 * radius_m);
  const Real induced2 = induced_m_s * induced_m_s;
  const Real whole2 = induced2 + edgewise2;
  return whole2 / (whole2 - near * near * induced2);
}

/// Power is induced power, T (Vc + v). In descent it is that of hover: momentum theory ends there,
/// and down to the speed of the induced velocity measured power is 0.8 to 1 of hover's (Leishman
/// 2006, 2.13.6).
template <typename Real>
[[nodiscard]] ThrusterOutput<Real> run(const Rotor& rotor, const Real& command,
                                       const ThrusterSurroundings<Real>& around) {
  const Real zero = Real{} + 0.0;
  const Real most = rotor.most_rad_s * speed_share(rotor.full_speed_voltage_v, around.voltage_v);
  const Real speed = within(command, zero, most);
  const Real free_n = rotor.thrust_n_s2 * (speed * speed);
  const Real climb_m_s = larger_of(around.advance_m_s, zero);
  const Real edgewise2 = around.across_m_s * around.across_m_s;
  const Real hover2 = free_n * (1 / rotor.disc_kg_m) + 1e-9;  // of a rotor that stands: no 0/0
  const Real induced_m_s = induced_velocity_m_s(hover2, climb_m_s, edgewise2);
  ThrusterOutput<Real> out;
  out.thrust_n = free_n * ground_effect(rotor.radius_m, around.height_m, edgewise2, induced_m_s);
  out.torque_n_m = rotor.torque_arm_m * free_n;
  out.power_w = (1 / rotor.efficiency) * (free_n * (climb_m_s + induced_m_s));
  out.drag_n_s_m = rotor.drag_n_s2_m * speed;
  return out;
}

}  // namespace slackwater::twin
