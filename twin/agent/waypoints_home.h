#pragma once
#include <vector>

#include "twin/agent/conduct.h"

namespace slackwater::twin {

/// The way home of a vehicle that conducts itself: round the structures, or back round the one it
/// works at where its line has come to lie about it.
[[nodiscard]] std::vector<Waypoint> waypoints_home(const Agent& agent, const AgentState& state);

/// What it would draw at its speed through the water or air of the last step, were that steady.
[[nodiscard]] double steady_power_w(const Agent& agent, const AgentState& state);

}  // namespace slackwater::twin
