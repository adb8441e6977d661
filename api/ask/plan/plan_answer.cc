#include "api/ask/plan/plan_answer.h"

#include <algorithm>
#include <optional>

#include "api/ask/plan/plan_rules.h"

namespace slackwater::api {

std::vector<std::string> names_of(const PlanProblem& problem,
                                  const std::vector<std::size_t>& vehicles) {
  std::vector<std::string> names;
  names.reserve(vehicles.size());
  for (const std::size_t k : vehicles) names.push_back(problem.vehicles[k].id);
  return names;
}

std::vector<VesselWay> ways_of_vessel(const PlanProblem& problem,
                                      const std::vector<Assignment>& assignments,
                                      std::size_t vessel) {
  struct Call {
    VesselStay stay;
    std::size_t place = 0;
  };
  std::vector<Call> calls;
  for (const Assignment& one : assignments) {
    if (one.vessel != vessel) continue;
    const PlanJob& job = problem.jobs[one.job];
    for (const VesselStay& stay : stays_of(problem, job, start_of(problem, one)))
      calls.push_back({stay, job.place});
  }
  std::stable_sort(calls.begin(), calls.end(),
                   [](const Call& a, const Call& b) { return a.stay.from < b.stay.from; });
  std::vector<VesselWay> ways;
  const PlanVessel& v = problem.vessels[vessel];
  std::optional<std::size_t> at;
  Minute free = 0;
  for (const Call& call : calls) {
    const auto [stay, place] = call;
    if (!at && v.port) {
      ways.push_back({*v.port, place, stay.from - v.way_min[*v.port][place], stay.from});
    } else if (at && *at != place) {
      ways.push_back({*at, place, free, free + v.way_min[*at][place]});
      free = 0;
    }
    at = place;
    free = std::max(free, stay.to);
  }
  if (at && v.port) ways.push_back({*at, *v.port, free, free + v.way_min[*at][*v.port]});
  return ways;
}

}  // namespace slackwater::api
