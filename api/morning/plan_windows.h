#pragma once
#include <filesystem>

#include "api/plan/plan_file.h"
#include "api/plan/windows_file.h"
#include "api/windows/windows.h"

namespace slackwater::api {

/// What the forecast says of a plan's tasks, each at each of its turbines by itself, on the grid
/// and the day of the plan.
/// @param question  of the site's windows; its tasks, turbines, hours and grid are the plan's
/// @param flown     windows of these tasks that were flown: what their flights leave of a start at
///                  the same turbine goes before what its limits say (`worth`)
/// @throws as `windows_of`
[[nodiscard]] WindowsFile windows_for_plan(const PlanFile& plan, WindowsQuestion question,
                                           const std::filesystem::path& store_folder,
                                           const std::vector<TaskWindows>& flown = {});

}  // namespace slackwater::api
