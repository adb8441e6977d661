#pragma once
#include <nlohmann/json_fwd.hpp>

#include "api/ask/plan/plan_answer.h"

namespace slackwater::api {

/// For programs: api/docs/plan.md has the schema.
[[nodiscard]] nlohmann::json plan_json(const PlanProblem& problem, const PlanAnswer& answer);

}  // namespace slackwater::api
