#pragma once
#include <filesystem>

#include "api/ask/run/scenario_run.h"

namespace slackwater::api {

/// A scenario and its water: all that it takes to run it.
struct ScenarioAtHand {
  twin::Scenario scenario;
  ScenarioWater water;
};

/// Reads a scenario and all that it names: its forecast, in the store or in a file, and the logs of
/// AIS of its traffic. @throws Error(invalid_input), Error(not_found), Error(unavailable)
[[nodiscard]] ScenarioAtHand scenario_at_hand(const std::filesystem::path& file,
                                              const std::filesystem::path& store_folder);

}  // namespace slackwater::api
