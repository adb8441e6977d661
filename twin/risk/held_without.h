#pragma once
#include <vector>

#include "twin/risk/start_chances.h"

namespace slackwater::twin {

/// How many members would keep each start if one of the task's limits did not count: what a vehicle
/// that bears more of it would change. Never fewer than `StartChance::held`.
/// @param limit  of the task's
/// Cost: that of `start_chances`, without what it says of rules and nearness.
[[nodiscard]] std::vector<std::size_t> held_without(const StartQuestion& question,
                                                    std::size_t limit);

}  // namespace slackwater::twin
