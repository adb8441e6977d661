#pragma once
#include <vector>

#include "twin/risk/phase_plan.h"
#include "twin/simulate/agent.h"

namespace slackwater::twin {

/// A vehicle's tasks as a planner sees them: its ways at the speeds that they are to be gone at, in
/// still water, and its stays. Corners, gathering way and the current are not in it.
[[nodiscard]] PhasePlan plan_of(const Triple<double>& start_m, const Mission& mission);

/// Where a vehicle is in a phase, as a planner takes it: in the middle of the places that it goes
/// to then, as high as it comes on its way and as low, for currents and winds change with height;
/// in a phase without a way of its own (a launch, a recovery) where it stands, the first time that
/// it comes to it. Nothing where its mission has no such phase.
/// @return the highest first; one where they are the same
[[nodiscard]] std::vector<Triple<double>> places_in(const Triple<double>& start_m,
                                                    const Mission& mission, Phase phase);

}  // namespace slackwater::twin
