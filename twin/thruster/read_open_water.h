#pragma once
#include "fields/base/config.h"
#include "twin/thruster/open_water.h"

namespace slackwater::twin {

/// Reads `open_water` of a propeller and what goes with it: wake_fraction, thrust_deduction,
/// torque_share, astern, astern_share.
/// @param c  the thruster
[[nodiscard]] OpenWater read_open_water(const Config& c, double diameter_m, double density_kg_m3);

}  // namespace slackwater::twin
