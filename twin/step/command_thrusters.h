#pragma once
#include "twin/control/autopilot.h"
#include "twin/step/vehicle_state.h"

namespace slackwater::twin {

/// What thrusters go by when they are asked for a thrust.
struct ThrustersMeet {
  Triple<double> through_m_s;  ///< the vehicle, of the fluid, body axes
  double voltage_v = 0;        ///< of the bus
  double height_m = 0;         ///< above ground or sea
};

/// The commands that give these thrusts. Measured thrusters are commanded by their curve at rest:
/// what the flow takes from it the integrals of the autopilot make good. The others go by the fluid
/// as well as it is known.
void command_thrusters(const Vehicle& vehicle, const std::array<double, most_mounts>& thrust_n,
                       const ThrustersMeet& meet, VehicleCommand<double>& command);
/// Those of all actuators that an autopilot asks for.
void command_effort(const Vehicle& vehicle, const Effort& effort, const ThrustersMeet& meet,
                    VehicleCommand<double>& command);

}  // namespace slackwater::twin
