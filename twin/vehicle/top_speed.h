#pragma once
#include "twin/control/autopilot.h"
#include "twin/vehicle/vehicle.h"

namespace slackwater::twin {

/// How fast a vehicle really goes ahead through still water or air, at most its autopilot's bound,
/// which is worked out from the thrust at rest.
///
/// In the water: where what its thrusters give at that speed meets its resistance, their power
/// bounded by the engine or by the most current of the battery. The crew transfer vessel: 13.5 of
/// 16.6 m/s. A multirotor: where its drag and that of its rotors takes all that its tilt, and the
/// thrust beside its weight, leave.
/// @param voltage_v    of the bus
/// @param has_battery  false: the bus is held, and gives any current
[[nodiscard]] double top_speed_m_s(const Vehicle& vehicle, const Autopilot& autopilot,
                                   double voltage_v, bool has_battery);

}  // namespace slackwater::twin
