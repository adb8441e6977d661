#pragma once
#include "fields/base/config.h"
#include "twin/clearance/lookout.h"

namespace slackwater::twin {

/// `clearance` of a scenario: `craft_m`, `structure_m`, `tether_m`, `vessel_m`, `vertical_m`, each
/// with the default of `StandOff`.
[[nodiscard]] StandOff read_stand_off(const Config& clearance);

}  // namespace slackwater::twin
