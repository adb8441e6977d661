#include "api/ask/plan/candidates.h"

#include <algorithm>

#include "api/ask/plan/plan_rules.h"

namespace slackwater::api {
namespace {

/// Every choice of one vehicle for each need, none twice.
void add_choices(const std::vector<std::vector<std::size_t>>& fit, Assignment team,
                 std::vector<Assignment>& teams) {
  if (team.vehicles.size() == fit.size()) {
    teams.push_back(std::move(team));
    return;
  }
  for (const std::size_t k : fit[team.vehicles.size()]) {
    if (std::find(team.vehicles.begin(), team.vehicles.end(), k) != team.vehicles.end()) continue;
    Assignment more = team;
    more.vehicles.push_back(k);
    add_choices(fit, std::move(more), teams);
  }
}

}  // namespace

std::vector<Assignment> teams_of(const PlanProblem& problem, std::size_t job) {
  std::vector<Assignment> teams;
  for (std::size_t v = 0; v < problem.vessels.size(); ++v) {
    if (problem.vessels[v].crews == 0) continue;
    std::vector<std::vector<std::size_t>> fit;
    for (const auto& kinds : problem.jobs[job].vehicles)
      fit.push_back(vehicles_of(problem, v, kinds));
    for (std::size_t c = 0; c < problem.crews.size(); ++c) {
      const PlanCrew& crew = problem.crews[c];
      if (crew.vessel.value_or(v) == v && is_skilled(crew, problem.jobs[job]))
        add_choices(fit, {job, 0, v, c, {}}, teams);
    }
  }
  return teams;
}

std::vector<Assignment> candidates_of(const PlanProblem& problem, std::size_t job) {
  std::vector<Assignment> candidates;
  const std::vector<Assignment> teams = teams_of(problem, job);
  for (std::size_t s = 0; s < problem.jobs[job].starts.size(); ++s) {
    for (Assignment one : teams) {
      one.start = s;
      if (!breach_of(problem, one)) candidates.push_back(std::move(one));
    }
  }
  return candidates;
}

}  // namespace slackwater::api
