#include "api/ask/plan/plan_answer.h"

#include <algorithm>
#include <optional>

#include "api/ask/plan/plan_rules.h"

namespace slackwater::api {

std::vector<std::string> names_of(const PlanProblem& problem,
                                  const std::vector<std::size_t>& vehicles) {
  std::vector<std::string> names;
  for (const std::size_t k : vehicles) names.push_back(problem.vehicles[k].id);
  return names;
}

std::vector<VesselWay> ways_of_vessel(const PlanProblem& problem,
                                      const std::vector<Assignment>& assignments,
                                      std::size_t vessel) {
  std::vector<VesselWay> ways;
  const PlanVessel& v = problem.vessels[vessel];
  std::optional<std::size_t> at;
  Minute free = 0;
  for (const Assignment& one : assignments) {  // by time
    if (one.vessel != vessel) continue;
    const std::size_t place = problem.jobs[one.job].place;
    const Minute begin = begin_of(problem, one);
    if (!at && v.port) {
      ways.push_back({*v.port, place, begin - v.way_min[*v.port][place], begin});
    } else if (at && *at != place) {
      ways.push_back({*at, place, free, free + v.way_min[*at][place]});
      free = 0;
    }
    at = place;
    free = std::max(free, end_of(problem, one));
  }
  if (at && v.port) ways.push_back({*at, *v.port, free, free + v.way_min[*at][*v.port]});
  return ways;
}

}  // namespace slackwater::api
