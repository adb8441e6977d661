#include "api/ask/plan/greedy_plan.h"

#include <algorithm>
#include <numeric>

#include "api/ask/plan/candidates.h"
#include "api/ask/plan/charging.h"
#include "api/ask/plan/plan_rules.h"

namespace slackwater::api {
namespace {

/// Whether an assignment goes with others; if so, `charges` are what all of them need.
bool fits(const PlanProblem& problem, const std::vector<std::size_t>& kits,
          std::vector<Assignment> others, const Assignment& one, std::vector<Charge>& charges) {
  for (const Assignment& other : others)
    if (breach_between(problem, kits, other, one)) return false;
  others.push_back(one);
  if (breach_of_room(problem, others)) return false;
  // Charged as before where that will do, else as soon as can be.
  if (!breach_of_packs(problem, others, charges)) return true;
  std::vector<Charge> anew = earliest_charges(problem, others);
  if (breach_of_packs(problem, others, anew)) return false;
  charges = std::move(anew);
  return true;
}

bool has_job(const PlanDraft& draft, std::size_t job) {
  return std::any_of(draft.assignments.begin(), draft.assignments.end(),
                     [&](const Assignment& one) { return one.job == job; });
}

void move_earlier(const PlanProblem& problem, const std::vector<std::size_t>& kits,
                  std::size_t index, PlanDraft& draft) {
  std::vector<Assignment> others = draft.assignments;
  const Assignment now = others[index];
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(index));
  const PlanJob& job = problem.jobs[now.job];
  Assignment moved = now;
  for (moved.start = 0; moved.start < now.start; ++moved.start) {
    if (job.starts[moved.start].probability < job.starts[now.start].probability ||
        breach_of(problem, moved) || !fits(problem, kits, others, moved, draft.charges))
      continue;
    draft.assignments[index] = moved;
    return;
  }
}

}  // namespace

bool add_where_it_fits(const PlanProblem& problem, std::size_t job, PlanDraft& draft) {
  const std::vector<std::size_t> kits = kits_of(problem);
  std::vector<Assignment> candidates = candidates_of(problem, job);
  std::stable_sort(candidates.begin(), candidates.end(),
                   [&](const Assignment& a, const Assignment& b) {
                     return start_of(problem, a).probability > start_of(problem, b).probability;
                   });
  for (const Assignment& one : candidates) {
    if (!fits(problem, kits, draft.assignments, one, draft.charges)) continue;
    draft.assignments.push_back(one);
    return true;
  }
  return false;
}

PlanDraft greedy_draft(const PlanProblem& problem) {
  std::vector<std::size_t> order(problem.jobs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return problem.jobs[a].priority > problem.jobs[b].priority;
  });
  PlanDraft draft;
  for (const std::size_t job : order) add_where_it_fits(problem, job, draft);
  sort_by_time(problem, draft.assignments);
  return draft;
}

void tidy(const PlanProblem& problem, PlanDraft& draft) {
  const std::vector<std::size_t> kits = kits_of(problem);
  std::vector<Charge> soonest = earliest_charges(problem, draft.assignments);
  if (!breach_of_packs(problem, draft.assignments, soonest)) draft.charges = std::move(soonest);
  sort_by_time(problem, draft.assignments);
  for (std::size_t i = 0; i < draft.assignments.size(); ++i) move_earlier(problem, kits, i, draft);
  for (std::size_t job = 0; job < problem.jobs.size(); ++job)
    if (!has_job(draft, job)) add_where_it_fits(problem, job, draft);
  sort_by_time(problem, draft.assignments);
  soonest = earliest_charges(problem, draft.assignments);
  if (!breach_of_packs(problem, draft.assignments, soonest)) draft.charges = std::move(soonest);
}

}  // namespace slackwater::api
