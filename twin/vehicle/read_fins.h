#pragma once
#include "fields/base/config.h"
#include "twin/vehicle/vehicle.h"

namespace slackwater::twin {

/// Reads the fins of a vehicle whose body is read: `fins`, two pairs alike, or `rudder` and
/// `elevator`, each by area and lift slope or by the derivatives of a published table. None: none.
void read_fins(const Config& config, Vehicle& vehicle);

}  // namespace slackwater::twin
