#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fields/base/config.h"
#include "twin/mission/work_site.h"
#include "twin/scenario/expand_mission.h"
#include "twin/scenario/scenario.h"

namespace slackwater::twin {

/// One agent of a task, made into a vehicle of the scenario: where it starts, what it does turbine
/// by turbine, and its conduct.
/// @param agent     entry of the task
/// @param over      what the mission says of it instead
/// @param stands_m  where a carrier stands by for it, turbine by turbine; empty: it has none
/// @param assumed      by the whole mission
/// @param by_sensors   how it navigates where neither entry says
/// @throws Error(invalid_input) with file and line
[[nodiscard]] ScenarioVehicle lay_out_agent(const std::string& name, const Config& agent,
                                            const std::optional<Config>& over,
                                            const MissionParts& parts,
                                            std::span<const WorkTurbine* const> turbines,
                                            std::span<const Triple<double>> stands_m,
                                            const std::vector<Assumption>& assumed,
                                            bool by_sensors);

}  // namespace slackwater::twin
