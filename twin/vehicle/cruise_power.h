#pragma once
#include "twin/control/autopilot.h"
#include "twin/vehicle/vehicle.h"

namespace slackwater::twin {

/// What a vehicle draws to go steadily ahead through still water or air, its hotel load with it:
/// in the water where what its thrusters give at that speed meets its resistance, a multirotor
/// where its rotors carry its weight and its drag. At speed 0 a multirotor hovers, and what swims
/// or floats draws its hotel load.
///
/// What bounds it (engine, battery) is left out: beyond `top_speed_m_s` it is the power at that
/// thrust all the same. W; mean, so without what waves and gusts take.
/// @param voltage_v  of the bus
[[nodiscard]] double cruise_power_w(const Vehicle& vehicle, const Autopilot& autopilot,
                                    double voltage_v, double speed_m_s);

}  // namespace slackwater::twin
