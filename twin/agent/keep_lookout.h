#pragma once
#include <filesystem>

#include "twin/agent/agent.h"

namespace slackwater::twin {

/// Reads what a plan names of data/leeway, lookouts, mammals and watches.
/// @throws Error(invalid_input)
void load_look_outs(Conduct& plan, const std::filesystem::path& data_folder);

/// Where whom a vehicle searches for was last known to be: as its plan says, or at the first
/// waypoint of its work, or where it starts.
[[nodiscard]] Triple<double> last_known_m(const PersonSearch& search, const Agent& agent,
                                          const Triple<double>& start_m);

/// The search and the watch of a vehicle at the start of a run, in the water that it lives in.
/// Noise without a place is at the structure that it works at, or where it starts.
/// @param begun  with the start as `left_m`
/// @throws Error(invalid_input) where the forecast has no water or wind at the last known position
void begin_look_outs(const Agent& agent, const ReadyConduct& conduct, std::uint64_t seed,
                     ConductState& begun);

/// One look of a vehicle for whom it searches and the animals it watches for, at each tick of its
/// conduct: he drifts in the current and the wind of 10 m where he is. Nothing where it does
/// neither.
void keep_lookout(const Agent& agent, double t_s, AgentState& state);

}  // namespace slackwater::twin
