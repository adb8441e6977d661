#pragma once
#include <string>
#include <vector>

#include "api/ask/plan/plan.h"
#include "fields/base/numbers/random.h"

// Days to plan, and a judge of plans that shares no line with what makes them.

namespace slackwater::tests {

/// What is wrong with a plan, walked through slot by slot and minute by minute; empty where nothing
/// is.
[[nodiscard]] std::string what_is_wrong(const api::PlanProblem& problem,
                                        const std::vector<api::Assignment>& assignments,
                                        const std::vector<api::Charge>& charges);

/// The most that a plan of this day can be worth, found by trying them all. For days in which no
/// two batteries share a charger.
[[nodiscard]] double best_value_by_trying(const api::PlanProblem& problem);

/// A small day of everything that a plan has to mind: two to four jobs, an hour a slot.
[[nodiscard]] api::PlanProblem small_random_day(Rng& random);

/// A working day of a farm: `jobs` tasks at as many turbines, `teams` crews, each with an ROV or a
/// UAV, two to a vessel, on a grid of 15 minutes; weather that comes up or goes down over the day.
[[nodiscard]] api::PlanProblem farm_day(std::size_t jobs, std::size_t teams, Rng& random);

/// Ways of one length between all places.
[[nodiscard]] std::vector<std::vector<api::Minute>> ways_of(std::size_t places, api::Minute way);

}  // namespace slackwater::tests
