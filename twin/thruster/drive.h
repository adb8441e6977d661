#pragma once
#include "twin/thruster/actuator_disc.h"
#include "twin/thruster/surroundings.h"

namespace slackwater::twin {

/// An outboard motor, pod or waterjet with a governor of its own, commanded by the thrust in N.
///
/// A jet of nozzle area A' is a disc of twice that area: both leave the fluid with the momentum rho
/// A' v^2.
struct Drive {
  double most_thrust_n = 0;
  double least_thrust_n = 0;  ///< astern: negative
  double disc_kg_m = 0;       ///< 2 rho A
  double efficiency =
      0;  ///< power of a loss-free disc over power of the bus, or of the engine's shaft
  double idle_power_w = 0;  ///< without thrust
  /// Induced velocity at rest of a disc that has all the engine's power, w0 = (efficiency P/(2 rho
  /// A))^(1/3); 0: the engine has always enough. Ahead alone.
  double full_power_induced_m_s = 0;
  double fuel_kg_j = 0;  ///< burnt per energy of the shaft; 0: it draws from the bus
};

/// What the engine can push with as fast as this.
template <typename Real>
[[nodiscard]] Real most_thrust_n(const Drive& drive, const Real& advance_m_s) {
  const Real most = Real{} + drive.most_thrust_n;
  const double w0 = drive.full_power_induced_m_s;
  if (!(w0 > 0)) return most;
  const Real through = flow_through_disc(Real{advance_m_s * (1 / w0)});
  return smaller_of(most, Real{(drive.disc_kg_m * w0 * w0) / through});
}

template <typename Real>
[[nodiscard]] ThrusterOutput<Real> run(const Drive& drive, const Real& command,
                                       const ThrusterSurroundings<Real>& around) {
  ThrusterOutput<Real> out;
  out.thrust_n = within(command, Real{Real{} + drive.least_thrust_n},
                        most_thrust_n(drive, around.advance_m_s));
  const Real power_w =
      drive.idle_power_w +
      (1 / drive.efficiency) * disc_power_w(drive.disc_kg_m, out.thrust_n, around.advance_m_s);
  if (drive.fuel_kg_j > 0)
    out.fuel_kg_s = drive.fuel_kg_j * power_w;
  else
    out.power_w = power_w;
  return out;
}

}  // namespace slackwater::twin
