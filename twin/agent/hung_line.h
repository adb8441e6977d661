#pragma once
#include <algorithm>
#include <array>

#include "twin/agent/agent.h"

namespace slackwater::twin {

/// All nodes of the line of a vehicle that has one, from its top to its attachment, NED; at a
/// barrier.
[[nodiscard]] inline std::array<Triple<double>, tether_nodes> hung_line(const Agent& agent,
                                                                        const AgentState& state) {
  const BodyState<double>& body = state.vehicle.body;
  std::array<Triple<double>, tether_nodes> nodes;
  nodes.front() = state.top.place_m;
  std::copy(state.tether.node_m.begin(), state.tether.node_m.end(), nodes.begin() + 1);
  nodes.back() = body.position_m + rotation_of(body.attitude).to_ned(agent.tether->attachment_m);
  return nodes;
}

/// Whether its line is in the water: it has one, whole, and is not aboard with it.
[[nodiscard]] inline bool has_line_out(const Agent& agent, const AgentState& state) noexcept {
  return agent.tether && !state.conduct.is_aboard && state.tether.whole > 0.5;
}

}  // namespace slackwater::twin
