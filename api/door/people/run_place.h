#pragma once
#include <nlohmann/json.hpp>
#include <span>

#include "api/ask/run/scenario_run.h"

namespace slackwater::people {

/// Where a run takes place: one that goes on, or one of a log that was made ready once more. What
/// it refers to stays as long as the run does.
struct RunPlace {
  const api::ScenarioWater& water;
  const twin::EnvironmentSampler& sampler;
  const std::vector<twin::TrafficVessel>* vessels;  ///< the traffic; null: none
  UtcTime start;
  GeoPoint origin;
};
/// @param agents  at least one
[[nodiscard]] RunPlace run_place(const api::ScenarioWater& water,
                                 std::span<const twin::Agent> agents, UtcTime start,
                                 GeoPoint origin);
[[nodiscard]] RunPlace run_place(const api::RunInHand& hand);

/// What of a welcome is of the place alone: `water`, `turbines`, `sea`, `bed`, `cables`,
/// `moorings` (api/docs/session_wire.md).
/// @param vehicles_m  where they begin: east, north
[[nodiscard]] nlohmann::json place_facts(const RunPlace& place,
                                         std::span<const Horizontal> vehicles_m);

/// Where vehicles are: east, north.
[[nodiscard]] std::vector<Horizontal> places_of(std::span<const twin::AgentState> states);

}  // namespace slackwater::people
