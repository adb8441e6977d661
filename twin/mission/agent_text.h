#pragma once
#include <optional>
#include <span>
#include <string>

#include "fields/base/config.h"
#include "twin/mission/expand_mission.h"
#include "twin/mission/work_site.h"

namespace slackwater::twin {

/// One agent of a task, made into a vehicle of the scenario: where it starts, what it does turbine
/// by turbine, and its conduct.
/// @param agent     entry of the task
/// @param over      what the mission says of it instead
/// @param stands_m  where a carrier stands by for it, turbine by turbine; empty: it has none
/// @param assumed   as YAML on one line; empty: nothing is
/// @return an entry of `vehicles`, as YAML. @throws Error(invalid_input)
[[nodiscard]] std::string agent_text(const std::string& name, const Config& agent,
                                     const std::optional<Config>& over, const MissionParts& parts,
                                     std::span<const WorkTurbine* const> turbines,
                                     std::span<const Triple<double>> stands_m,
                                     const std::string& assumed);

}  // namespace slackwater::twin
