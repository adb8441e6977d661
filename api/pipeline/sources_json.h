#pragma once
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "fields/record/source_use.h"

namespace slackwater::api {

/// The `sources` of a forecast as JSON: one object a stretch (docs/json.md).
[[nodiscard]] nlohmann::json sources_json(const std::vector<SourceUse>& uses);

}  // namespace slackwater::api
