#include <algorithm>
#include <cmath>

#include "twin/thruster/thrust_curve.h"
#include "twin/thruster/thruster.h"

namespace slackwater::twin {

double rest_thrust_n(double disc_kg_m, double thrust_n, double advance_m_s) {
  const double way = way_of(thrust_n);
  const double size_n = std::abs(thrust_n);
  const double half = 0.5 * way * advance_m_s;
  const double through = half + std::sqrt(half * half + size_n / disc_kg_m);  // Va + w
  // P = T (Va + w) = 2 rho A w0^3.
  const double induced_m_s = std::cbrt(size_n * through / disc_kg_m);
  if (way * advance_m_s > -most_backflow * induced_m_s)
    return way * disc_kg_m * induced_m_s * induced_m_s;
  static const double held = flow_through_disc(-most_backflow);
  return thrust_n * held;
}

double command_for(const ThrustTable& table, double thrust_n,
                   const ThrusterSurroundings<double>& around) {
  const bool is_at_rest = around.advance_m_s == 0 || !(std::abs(thrust_n) > 0);
  return ThrustCurve(table, around.voltage_v)
      .command_for(is_at_rest ? thrust_n
                              : rest_thrust_n(table.disc_kg_m, thrust_n, around.advance_m_s));
}

double command_for(const Propeller& propeller, double thrust_n, double advance_m_s) {
  const OpenWater& water = propeller.open_water;
  if (water.is_known()) return shaft_for(water, thrust_n / water.thrust_share, advance_m_s);
  const double thrust_n_s2 = thrust_n < 0 ? propeller.astern_thrust_n_s2 : propeller.thrust_n_s2;
  return std::copysign(std::sqrt(std::abs(thrust_n) / thrust_n_s2), thrust_n);
}

double command_for(const Thruster& thruster, double thrust_n,
                   const ThrusterSurroundings<double>& around) {
  const auto limited = [&](double command) {
    return std::clamp(command, thruster.least_command, thruster.most_command);
  };
  switch (thruster.kind) {
    case ThrusterKind::table:
      return command_for(thruster.table, thrust_n, around);
    case ThrusterKind::propeller:
      return limited(command_for(thruster.propeller, thrust_n, around.advance_m_s));
    case ThrusterKind::rotor: {
      const Rotor& rotor = thruster.rotor;
      if (!(thrust_n > 0)) return thruster.least_command;
      // From eighty radii up the ground adds less than 1e-5.
      if (around.height_m > 80 * rotor.radius_m)
        return limited(std::sqrt(thrust_n / rotor.thrust_n_s2));
      // What the ground adds depends on the thrust but little: once is enough near hover, and exact
      // at rest.
      const double edgewise2 = around.across_m_s * around.across_m_s;
      const double induced_m_s = induced_velocity_m_s(thrust_n / rotor.disc_kg_m,
                                                      std::max(around.advance_m_s, 0.0), edgewise2);
      const double free_n =
          thrust_n / ground_effect(rotor.radius_m, around.height_m, edgewise2, induced_m_s);
      return limited(std::sqrt(free_n / rotor.thrust_n_s2));
    }
    case ThrusterKind::drive:
      break;
  }
  return limited(thrust_n);
}

}  // namespace slackwater::twin
