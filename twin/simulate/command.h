#pragma once
#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

#include "twin/simulate/agent.h"

namespace slackwater::twin {

/// Other waypoints in the place of what is left of the route, from where the vehicle takes itself
/// to be (`replace_waypoints`). None: it stays where it is.
struct Reroute {
  std::vector<Waypoint> waypoints;
};

/// The vehicle put elsewhere, or in other motion. Its mission, its tether and what its instruments
/// told it stay as they were.
struct PutVehicle {
  VehicleState<double> vehicle;
};

/// What is done to a vehicle from outside while a run goes on. A value: the list of those that a
/// run took makes the run again.
struct Command {
  /// Takes effect before this step is made; once that is past, before the next one.
  std::uint64_t step = 0;
  std::size_t agent = 0;
  std::variant<Reroute, PutVehicle> what;
};

/// @throws ContractViolation for waypoints that are not finite
void expect_sound(const Command& command);

/// A vehicle that has halted stays as it is.
void apply(const Command& command, const Agent& agent, AgentState& state);

}  // namespace slackwater::twin
