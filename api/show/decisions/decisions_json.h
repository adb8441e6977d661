#pragma once
#include <nlohmann/json_fwd.hpp>

#include "api/ask/decisions/decide.h"
#include "api/ask/decisions/decisions.h"

// Decisions for programs: api/docs/json.md has the schema.

namespace slackwater::api {

[[nodiscard]] nlohmann::json decision_json(const DecisionAnswer& decision);
[[nodiscard]] nlohmann::json record_json(const DecisionsRecord& record);
[[nodiscard]] nlohmann::json decisions_json(const DecisionsAnswer& answer);
/// What `decide` prints: the record as it was filed.
[[nodiscard]] nlohmann::json recorded_json(const DecisionMade& made);

}  // namespace slackwater::api
