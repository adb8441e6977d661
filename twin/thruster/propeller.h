#pragma once
#include "twin/thruster/actuator_disc.h"
#include "twin/thruster/surroundings.h"

namespace slackwater::twin {

/// A propeller whose shaft turns as told: T = Kt rho D^4 w|w|, commanded by the shaft's speed in
/// rad/s.
struct Propeller {
  double thrust_n_s2 = 0;  ///< Kt rho D^4
  double disc_kg_m = 0;    ///< 2 rho A
  double efficiency = 0;  ///< power of a loss-free disc over electrical power: blades, shaft, motor
  double most_rad_s = 0;  ///< either way
  double full_speed_voltage_v = 0;  ///< of the bus, from which on it turns that fast; 0: always
};

template <typename Real>
[[nodiscard]] ThrusterOutput<Real> run(const Propeller& propeller, const Real& command,
                                       const ThrusterSurroundings<Real>& around) {
  const Real most =
      propeller.most_rad_s * speed_share(propeller.full_speed_voltage_v, around.voltage_v);
  const Real shaft = within(command, Real{-most}, most);
  ThrusterOutput<Real> out;
  out.thrust_n = propeller.thrust_n_s2 * (absolute(shaft) * shaft);
  out.power_w = (1 / propeller.efficiency) *
                disc_power_w(propeller.disc_kg_m, out.thrust_n, around.advance_m_s);
  return out;
}

}  // namespace slackwater::twin
