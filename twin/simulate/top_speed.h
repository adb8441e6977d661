#pragma once
#include "twin/control/autopilot.h"
#include "twin/vehicle/vehicle.h"

namespace slackwater::twin {

/// How fast a craft that floats really goes through still water: where what its thrusters give at
/// that speed, their power being bounded, meets its resistance; at most the autopilot's bound,
/// which is worked out from the thrust at rest. The crew transfer vessel: 13.5 of 16.6 m/s. Of
/// other vehicles the autopilot's bound.
[[nodiscard]] double top_speed_m_s(const Vehicle& vehicle, const Autopilot& autopilot,
                                   double voltage_v);

}  // namespace slackwater::twin
