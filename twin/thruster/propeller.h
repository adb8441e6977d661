#pragma once
#include "twin/thruster/actuator_disc.h"
#include "twin/thruster/open_water.h"
#include "twin/thruster/surroundings.h"

namespace slackwater::twin {

/// A propeller whose shaft turns as told, commanded by its speed in rad/s: T = Kt rho D^4 w|w| at
/// any speed through the water, or as it does in open water where that is known.
struct Propeller {
  double thrust_n_s2 = 0;         ///< Kt rho D^4, at rest
  double astern_thrust_n_s2 = 0;  ///< likewise, of a shaft that turns backwards
  double disc_kg_m = 0;           ///< 2 rho A
  /// Power of a loss-free disc over electrical power: blades, shaft, motor; with K_Q: power of the
  /// shaft over electrical power.
  double efficiency = 0;
  double most_rad_s = 0;
  double most_astern_rad_s = 0;
  double full_speed_voltage_v = 0;  ///< of the bus, from which on it turns that fast; 0: always
  OpenWater open_water;
};

/// Called for those whose open water is known, and never made part of its caller: the registers of
/// everybody's step are full.
template <typename Real>
[[gnu::noinline, gnu::flatten]] ThrusterOutput<Real> run_in_open_water(const Propeller& propeller,
                                                                       const Real& shaft_rad_s,
                                                                       const Real& advance_m_s) {
  const OpenWater& water = propeller.open_water;
  const OpenWaterLoad<Real> load = load_of(water, shaft_rad_s, advance_m_s);
  const Real flow_m_s = water.flow_share * advance_m_s;
  ThrusterOutput<Real> out;
  out.thrust_n = water.thrust_share * load.thrust_n;
  out.torque_n_m = water.torque_share * load.torque_n_m;
  // A shaft that the water turns gives nothing back.
  const Real used_w = water.has_torque
                          ? larger_of(Real{shaft_rad_s * load.torque_n_m}, Real{} + 0.0)
                          : disc_power_w(propeller.disc_kg_m, load.thrust_n, flow_m_s);
  out.power_w = (1 / propeller.efficiency) * used_w;
  return out;
}

template <typename Real>
[[nodiscard]] ThrusterOutput<Real> run(const Propeller& propeller, const Real& command,
                                       const ThrusterSurroundings<Real>& around) {
  const Real reach = speed_share(propeller.full_speed_voltage_v, around.voltage_v);
  const Real shaft = within(command, Real{-(propeller.most_astern_rad_s * reach)},
                            Real{propeller.most_rad_s * reach});
  if (propeller.open_water.is_known())
    return run_in_open_water(propeller, shaft, around.advance_m_s);
  const Real thrust_n_s2 =
      select(shaft < 0.0, Real{} + propeller.astern_thrust_n_s2, Real{} + propeller.thrust_n_s2);
  ThrusterOutput<Real> out;
  out.thrust_n = thrust_n_s2 * (absolute(shaft) * shaft);
  out.power_w = (1 / propeller.efficiency) *
                disc_power_w(propeller.disc_kg_m, out.thrust_n, around.advance_m_s);
  return out;
}

/// The slowest shaft that gives a thrust, with no bound to its speed.
[[nodiscard]] double command_for(const Propeller& propeller, double thrust_n, double advance_m_s);

}  // namespace slackwater::twin
