#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "api/ask/run/scenario_run.h"
#include "fields/site/constraint_area.h"
#include "twin/mission/conduct.h"
#include "twin/risk/consequence.h"
#include "twin/scenario/expand_mission.h"

namespace slackwater::api {

/// A mission as it will be flown.
struct LoadedMission {
  std::string name;
  std::string site;
  twin::ExpandedMission expanded;  ///< its scenario stands beside it
  twin::Scenario scenario;
  ScenarioWater water;
  std::vector<ConstraintArea> areas;            ///< of the site
  std::vector<twin::Consequence> consequences;  ///< of what can go wrong, as the tasks say it
};

/// Lays out a mission: reads the tasks and the site that it names. Its water is not looked for.
/// @param folder   that the files it names count from
/// @param assumed  beside those of the mission
/// @param height_errors  whether the waves of a forecast err, whatever the mission says
/// @param thinned_by  of the work of all agents, beside what the mission says of its intensity
/// @throws Error(invalid_input), Error(not_found)
[[nodiscard]] LoadedMission lay_out_mission(const Config& mission,
                                            const std::filesystem::path& folder,
                                            const std::filesystem::path& store_folder,
                                            const std::vector<twin::Assumption>& assumed,
                                            std::optional<bool> height_errors = {},
                                            const twin::Intensity& thinned_by = {});

/// Reads a mission, the tasks and the site that it names, and finds its water.
/// @param assumed            beside those of the mission
/// @param height_errors  whether the waves of a forecast err, whatever the mission says
/// @throws Error(invalid_input), Error(not_found)
[[nodiscard]] LoadedMission load_mission(const std::filesystem::path& file,
                                         const std::filesystem::path& store_folder,
                                         const std::vector<twin::Assumption>& assumed,
                                         std::optional<bool> height_errors);

/// The sheet of a task: of data/tasks by its id, else a file, counted from a folder.
/// @throws Error(not_found) that lists the ids and names the nearest
[[nodiscard]] Config load_task(const std::string& id, const std::filesystem::path& folder);
/// Ids of the tasks that come with the program, sorted.
[[nodiscard]] std::vector<std::string> known_tasks();

}  // namespace slackwater::api
