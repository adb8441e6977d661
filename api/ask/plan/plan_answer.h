#pragma once
#include <string>
#include <vector>

#include "api/ask/plan/plan.h"
#include "api/ask/plan/plan_change.h"

namespace slackwater::api {

/// A plan with what there is to say about it.
struct PlanAnswer {
  std::string name;
  std::string site;
  Plan plan;
  std::vector<PlanChange> changes;  ///< since an earlier plan
  bool is_compared = false;         ///< there was one
  double time_limit_s = 0;
};

/// A way of a vessel from one place to the next.
struct VesselWay {
  std::size_t from = 0;
  std::size_t to = 0;
  Minute leaves = 0;  ///< as late as will do out of port, as soon as the work is done elsewhere
  Minute arrives = 0;
};
/// The ways of a vessel over the day, out of port and home again; none where it stays in port.
[[nodiscard]] std::vector<VesselWay> ways_of_vessel(const PlanProblem& problem,
                                                    const std::vector<Assignment>& assignments,
                                                    std::size_t vessel);

/// Who they are, in the order given.
[[nodiscard]] std::vector<std::string> names_of(const PlanProblem& problem,
                                                const std::vector<std::size_t>& vehicles);

}  // namespace slackwater::api
