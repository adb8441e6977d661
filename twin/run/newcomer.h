#pragma once
#include <string>

#include "twin/agent/agent.h"

namespace slackwater::twin {

/// Who is to join a run while it goes on: a vehicle of the catalogue, level and at rest. It has no
/// mission and keeps its place until somebody commands it.
struct Newcomer {
  std::string model;  ///< id in data/vehicles, never a path
  std::string name;
  Triple<double> position_m;  ///< NED; what floats does so, whatever this says of its height
  double heading_rad = 0;
};

/// One that has been made ready (`NewcomerYard`): the run has but to put it beside its other
/// vehicles.
struct ReadyNewcomer {
  Agent agent;
  AgentState state;
};

}  // namespace slackwater::twin
