#pragma once
#include <nlohmann/json_fwd.hpp>

#include "api/ask/run/scenario_run.h"

namespace slackwater::api {

/// What a run met and followed, for people: a line for each alarm and each track. Nothing where
/// there was no traffic.
void print_traffic(const ScenarioResult& result);
/// `traffic` of `simulate --json`; null where there was none.
[[nodiscard]] nlohmann::json traffic_json(const ScenarioResult& result);

}  // namespace slackwater::api
