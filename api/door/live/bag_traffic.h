#pragma once
#include <filesystem>

#include "api/ask/run/scenario_run.h"

namespace slackwater::live {

/// The vehicles of a bag as vessels that pass by a run, where they were then, counted from the
/// bag's first message: by `/NAME/pose`, else `/NAME/odometry`, in `map` about the run's own
/// origin. Their MMSI are 980000001 and following (craft of a parent ship; ITU-R M.585).
/// @throws Error(invalid_input) for a bag without such a topic, for a place that is no number or
///         more than 1000 km from the origin, and what a bag throws
void add_bag_traffic(const std::filesystem::path& bag, const twin::Scenario& scenario,
                     api::ScenarioWater& water);

}  // namespace slackwater::live
