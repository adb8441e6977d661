#include "api/ask/plan/plan.h"

#include <algorithm>
#include <tuple>

namespace slackwater::api {

double Plan::gap() const noexcept {
  if (is_proven || bound <= value) return 0;
  return value > 0 ? (bound - value) / value : 1;
}

double value_of(const PlanProblem& problem, const std::vector<Assignment>& assignments) {
  double value = 0;
  for (const Assignment& one : assignments)
    value += problem.jobs[one.job].priority * start_of(problem, one).probability;
  return value;
}

void sort_by_time(const PlanProblem& problem, std::vector<Assignment>& assignments) {
  std::sort(assignments.begin(), assignments.end(), [&](const Assignment& a, const Assignment& b) {
    return std::tuple(start_of(problem, a).slot, a.job) <
           std::tuple(start_of(problem, b).slot, b.job);
  });
}

}  // namespace slackwater::api
