#pragma once
#include "api/ask/plan/plan.h"

namespace slackwater::api {

/// The plan of a day that is worth most: the sum over the jobs that it does of priority times the
/// probability of their start. Where a least probability is asked for, no start has less.
///
/// Found by branch and cut. At the time limit the best found so far is given, with what no plan can
/// exceed; it is never worse than `greedy_draft`. Deterministic where it is proven.
/// @param problem       sound
/// @param time_limit_s  of the wall clock, more than 0
/// @throws Error(internal) for a plan that breaks a rule: every plan is checked before it is given
[[nodiscard]] Plan make_plan(const PlanProblem& problem, double time_limit_s);

}  // namespace slackwater::api
