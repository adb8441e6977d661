#pragma once
#include "api/ask/plan/day_chances.h"
#include "api/ask/plan/plan_file.h"
#include "api/ask/plan/plan_problem.h"

namespace slackwater::api {

/// A plan's file and the chances of its day, as a problem.
///
/// - A start that lies between two of the windows has the smaller of their probabilities and the
///   longer of their durations, where they are no more than an hour apart.
/// - A start is left out whose work, with its contingency, goes beyond the daylight that is asked
///   for, or goes on in an exclusion area that is in force.
/// - Vessels keep out of exclusion areas that are in force at any time of the day (`sea_way_m`),
///   and their ways are rounded up to whole minutes.
///
/// @param least_probability  see PlanProblem
/// @throws Error(invalid_input) for windows of another site or day, without one of the tasks; for
///         tasks that are longer than the day, or for which no vessel has all that they take
[[nodiscard]] PlanProblem problem_of(const PlanFile& plan, const DayChances& windows,
                                     double least_probability);

}  // namespace slackwater::api
