#pragma once
#include <string>
#include <vector>

#include "api/ask/plan/plan.h"
#include "api/ask/plan/plan_rules.h"

namespace slackwater::api {

/// Why each job that a plan leaves is left, in words: no start with a chance, none within the hours
/// of those who could do it, or what it wants is taken, by what, from when to when.
[[nodiscard]] std::vector<LeftJob> left_jobs(const PlanProblem& problem, const Plan& plan);

/// "07:15", by the clocks of the plan's zone.
[[nodiscard]] std::string clock_text(const PlanProblem& problem, Minute minute);
/// "93 %", "0.4 %".
[[nodiscard]] std::string chance_text(double probability);
/// "rov1 is at A02 from 07:15 to 10:00 (cp_anode@A02)": what an assignment holds that another
/// wants.
[[nodiscard]] std::string taken_text(const PlanProblem& problem, const Breach& breach,
                                     const Assignment& by);

}  // namespace slackwater::api
