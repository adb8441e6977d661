#pragma once
#include <filesystem>
#include <optional>

#include "api/ask/run/scenario_run.h"

namespace slackwater::api {

// What a log was run of, for who looks at it again.

/// @param path  of the log, for errors
/// @throws Error(invalid_input) for a log without a scenario
[[nodiscard]] twin::Scenario scenario_of_log(const ingest::TrajectoryFile& log,
                                             const std::filesystem::path& path);

/// Its water, with the traffic that the log has, as it was heard then.
/// @param forecast  where given, this file and not that of the store
/// @throws as `water_of_log`
[[nodiscard]] ScenarioWater logged_water(const ingest::TrajectoryFile& log,
                                         const twin::Scenario& scenario,
                                         const std::filesystem::path& store_folder,
                                         const std::optional<std::filesystem::path>& forecast);

}  // namespace slackwater::api
