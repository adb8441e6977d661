#pragma once
#include <nlohmann/json_fwd.hpp>

#include "api/rehearse/scenario_run.h"

namespace slackwater::api {

/// How near each vehicle came to what was around it, and its clearance alarms, for people: a line
/// each. Nothing for one that met nobody and does not keep clear.
void print_clearance(const ScenarioResult& result);
/// `closest` of a vehicle of `simulate --json`; null where there was nothing.
[[nodiscard]] nlohmann::json closest_json(const Closest& closest);
/// `clearance`; null for one that does not keep clear.
[[nodiscard]] nlohmann::json clearance_json(const VehicleSummary& vehicle);

}  // namespace slackwater::api
