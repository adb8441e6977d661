#pragma once
#include <array>

#include "twin/vehicle/vehicle.h"

namespace slackwater::twin {

/// The thrusters of a multirotor that hangs in still air; those of others at rest.
/// @param height_m  above ground or sea
[[nodiscard]] std::array<double, most_mounts> hovering_thrusters(const Vehicle& vehicle,
                                                                 double voltage_v, double height_m);

}  // namespace slackwater::twin
