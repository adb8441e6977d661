#pragma once
#include <span>

#include "twin/agent/agent.h"
#include "twin/scenario/scenario.h"

namespace slackwater::twin {

/// Makes those that carry others, and those that are carried, ready: lines that hang from decks are
/// laid, as soon as it is known where these are, or taken aboard with their vehicle.
/// @param agents, states  of the scenario's vehicles, in its order, each set up by itself
/// @throws Error(invalid_input) for a carrier that stands by less often than it is waited for, one
///         that does not float, and a line that does not reach
void ready_company(const Scenario& scenario, std::span<const Agent> agents,
                   std::span<AgentState> states);

}  // namespace slackwater::twin
