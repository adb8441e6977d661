#pragma once
#include <filesystem>

#include "api/ask/plan/day_chances.h"
#include "api/ask/plan/plan_file.h"
#include "api/ask/windows/windows.h"

namespace slackwater::api {

/// What the forecast says of a plan's tasks, each at each of its turbines by itself, on the grid
/// and the day of the plan. The forecast is read once at most: not at all where the question has
/// its water.
/// @param question  of the site's windows; its tasks, turbines, hours and grid are the plan's
/// @param flown     windows of these tasks that were flown: what their flights leave of a start at
///                  the same turbine goes before what its limits say (`worth`)
/// @return the numbers that `slackwater windows --json` would tell of them
/// @throws as `windows_of`
[[nodiscard]] DayChances windows_for_plan(const PlanFile& plan, WindowsQuestion question,
                                          const std::filesystem::path& store_folder,
                                          const std::vector<TaskWindows>& flown = {});

/// The chances of a task's starts as a plan takes them, rounded as they are told.
[[nodiscard]] DayChances::Task chances_of(const TaskWindows& task);

}  // namespace slackwater::api
