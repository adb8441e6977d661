#pragma once
#include "twin/agent/agent.h"

namespace slackwater::twin {

/// One look of a vehicle that conducts itself at everything that its tree asks about, before that
/// is ticked: faults that begin or end, its phase, its power and the way home, how far its line is
/// wound up, the deck that it works from, and its limits.
/// @param carrier  as of the last barrier; null: it has none
void look_about(const Agent& agent, double t_s, AgentState& state, const AgentState* carrier);

}  // namespace slackwater::twin
