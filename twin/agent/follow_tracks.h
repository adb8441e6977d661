#pragma once
#include <span>
#include <string>
#include <vector>

#include "twin/agent/agent.h"
#include "twin/scenario/scenario.h"

namespace slackwater::twin {

/// A vehicle of a scenario with the tracks that it follows put into its tasks and, where it is to
/// start on its track, its start: where the track is then, as fast as it is, or where it begins
/// later, at rest.
/// @throws Error(invalid_input) for a vessel that is not among these (some are named), a track that
///         says nothing of the run's time, one that jumps during it, and a start on a track for
///         what does not float
[[nodiscard]] ScenarioVehicle with_tracks(const ScenarioVehicle& entry, const Vehicle& vehicle,
                                          std::span<const TrafficVessel> vessels,
                                          double duration_s);

/// What a vehicle cannot keep up with, in words: tracks whose way between two reports is faster
/// than it.
[[nodiscard]] std::vector<std::string> too_fast_tracks(const Agent& agent, double duration_s);

/// The vessels whose tracks a vehicle follows: it is one of them then, and needs no alarm about
/// itself.
[[nodiscard]] std::vector<std::uint32_t> followed_by(const Agent& agent);

}  // namespace slackwater::twin
