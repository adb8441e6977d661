#pragma once
#include <nlohmann/json_fwd.hpp>

#include "api/ask/traffic/traffic_about.h"

namespace slackwater::api {

/// For programs and the page: api/docs/json.md has the schema.
[[nodiscard]] nlohmann::json traffic_json(const TrafficQuestion& question,
                                          const TrafficHeard& heard, const TrafficAnswer& answer);

}  // namespace slackwater::api
