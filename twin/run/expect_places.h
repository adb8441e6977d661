#pragma once
#include "twin/agent/agent.h"
#include "twin/scenario/scenario.h"

namespace slackwater::twin {

/// That a vehicle can be where it starts and where it is to go.
/// @param t_s  of the run, when it starts
/// @param is_without_currents  of water it is enough that it is there
/// @throws Error(invalid_input) for a place outside the forecast, on land, below the bed, in a
///         structure, above the sea for what swims, below it for what flies, and for a way through
///         a structure
void expect_places(const Scenario& scenario, const ScenarioVehicle& entry, const Agent& agent,
                   double t_s, bool is_without_currents = false);

}  // namespace slackwater::twin
