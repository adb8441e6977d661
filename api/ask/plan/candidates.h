#pragma once
#include <vector>

#include "api/ask/plan/plan.h"

namespace slackwater::api {

/// Every way to do a job that breaks no rule by itself: each start with each vessel, crew and
/// choice of vehicles.
[[nodiscard]] std::vector<Assignment> candidates_of(const PlanProblem& problem, std::size_t job);

/// Every vessel, crew and choice of vehicles that could do a job at some time, the times aside.
[[nodiscard]] std::vector<Assignment> teams_of(const PlanProblem& problem, std::size_t job);

}  // namespace slackwater::api
