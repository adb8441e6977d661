#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "api/ask/plan/plan.h"

namespace slackwater::api {

/// Crews, or vehicles, that nothing tells apart: a search need not try them one for another.
using Pool = std::vector<std::size_t>;

/// Crews of the same skills, shift and vessel.
[[nodiscard]] std::vector<Pool> crew_pools(const PlanProblem& problem);
/// Vehicles of the same kind, vessel, battery and swap.
[[nodiscard]] std::vector<Pool> vehicle_pools(const PlanProblem& problem);

/// Gives assignments, whose crews and vehicles are any of their pools, members who are free: each
/// on one vessel all day, the fewest that will do.
/// @param assignments  by time
void share_out(const PlanProblem& problem, std::span<Assignment> assignments);

}  // namespace slackwater::api
