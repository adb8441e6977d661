#pragma once
#include "twin/agent/agent.h"
#include "twin/scenario/scenario.h"

namespace slackwater::twin {

/// That every speed a scenario asks of a vehicle is one that it makes: by its own thrust and drag,
/// or its rotors and tilt. Over ground a craft that the water carries along may be asked for up to
/// twice that. An AUV steers by its fins, and has a least speed too.
/// @throws Error(invalid_input) with what was found and what the vehicle makes
void expect_speeds(const ScenarioVehicle& entry, const Agent& agent);

}  // namespace slackwater::twin
