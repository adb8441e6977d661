#pragma once
#include <string>

#include "api/ask/plan/plan_answer.h"

namespace slackwater::api {

/// "6 of 7 jobs planned, worth 11.88 of 17 (priority x probability); no plan is worth more."
[[nodiscard]] std::string worth_text(const PlanProblem& problem, const Plan& plan);

/// "94 %", or "70 %, marginal", "30 %, no-go" of what the usual rule would not call a go.
[[nodiscard]] std::string chance_and_verdict(double probability);

/// For people: what comes of it, then a table by time, the vessels' ways, what is left and why.
[[nodiscard]] std::string plan_text(const PlanProblem& problem, const PlanAnswer& answer);

}  // namespace slackwater::api
