#include "api/ask/plan/make_plan.h"

#include <algorithm>
#include <tuple>

#include "api/ask/plan/branch_and_cut.h"
#include "api/ask/plan/greedy_plan.h"
#include "api/ask/plan/left_jobs.h"
#include "api/ask/plan/plan_rules.h"
#include "fields/base/check.h"
#include "fields/base/error.h"

namespace slackwater::api {
namespace {

/// As much as rounding leaves between two sums of the same worth.
constexpr double rounding = 1e-6;

}  // namespace

Plan make_plan(const PlanProblem& problem, double time_limit_s) {
  expects(time_limit_s > 0, "a plan takes time");
  expect_sound(problem);
  PlanDraft best = greedy_draft(problem);
  const PlanModel model = model_of(problem);
  const LinearAnswer answer = maximise(model.linear, time_limit_s);
  if (!answer.values.empty()) {
    PlanDraft found = draft_of(problem, model, answer.values);
    if (value_of(problem, found.assignments) >=
        value_of(problem, best.assignments) - (answer.is_proven ? rounding : 0))
      best = std::move(found);
  }
  tidy(problem, best);
  if (breach_in(problem, best.assignments, best.charges))
    throw Error(ErrorKind::internal, "the plan that was found breaks a rule");
  Plan plan;
  plan.value = value_of(problem, best.assignments);
  plan.bound = std::max(plan.value, answer.bound);
  plan.is_proven = answer.is_proven || plan.bound - plan.value <= rounding * plan.value;
  if (plan.is_proven) plan.bound = plan.value;
  plan.assignments = std::move(best.assignments);
  plan.charges = std::move(best.charges);
  std::sort(plan.charges.begin(), plan.charges.end(), [](const Charge& a, const Charge& b) {
    return std::tie(a.slot, a.battery, a.charger) < std::tie(b.slot, b.battery, b.charger);
  });
  plan.left = left_jobs(problem, plan);
  return plan;
}

}  // namespace slackwater::api
