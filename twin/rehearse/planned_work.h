#pragma once
#include <optional>
#include <vector>

#include "twin/agent/agent.h"
#include "twin/risk/workability/phase_plan.h"

namespace slackwater::twin {

/// A vehicle's tasks as a planner sees them: its ways at the speeds that they are to be gone at, in
/// still water, and its stays. Corners, gathering way, the current and the way that its carrier
/// takes it are not in it.
[[nodiscard]] PhasePlan plan_of(const Triple<double>& start_m, const Mission& mission);

/// Where a vehicle is in a phase, as a planner takes it.
struct PhaseReach {
  Triple<double> middle_m;  ///< of the places that it goes to; without a way, where it stands first
  Triple<double> highest_m;  ///< of its ways and stays
  Triple<double> lowest_m;
  /// Courses that its bow has: of the legs at whose end it stays, where it stays at all, else of
  /// all its legs. Empty where none leads anywhere.
  std::vector<Course> bows;
};
/// Nothing where its mission has no such phase.
[[nodiscard]] std::optional<PhaseReach> reach_in(const Triple<double>& start_m,
                                                 const Mission& mission, Phase phase);

}  // namespace slackwater::twin
