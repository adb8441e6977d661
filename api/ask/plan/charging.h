#pragma once
#include <span>
#include <vector>

#include "api/ask/plan/plan.h"

namespace slackwater::api {

/// Charges each pack on the first charger that is free once it is back; those that are back first
/// go first, and then those of the earlier battery. With one battery a charger nothing gives
/// charged packs sooner.
[[nodiscard]] std::vector<Charge> earliest_charges(const PlanProblem& problem,
                                                   std::span<const Assignment> assignments);

}  // namespace slackwater::api
