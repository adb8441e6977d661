#pragma once
#include <span>

#include "twin/agent/agent.h"
#include "twin/step/step_dispatch.h"

namespace slackwater::twin {

/// Looks and pulls as rare as they may be: in the mean period of the sea (2 pi sqrt(m0/m2), null:
/// none) ten looks and twenty pulls, but a look each 0.5 s and a pull each 0.1 s at the least, more
/// pulls of lines shorter than 40 m, whose segments turn faster; as far as whole steps allow.
/// @param line_m  of tether paid out; 0: none
[[nodiscard]] CoarsePlan plan_coarse(double dt_s, const SeaRealisation* sea,
                                     double line_m) noexcept;

/// Before the vehicles of a block make their step of `t_s`: those of them that are coarse look at
/// the water ahead where they have come to the end of what they know, and let their tethers pull
/// where it is time, eight at once (`block`) or one by one (null), with the same bits. The vehicles
/// are of one kind; others than coarse ones, and halted ones, are left alone. No allocation.
void make_coarse_step(std::span<const Agent> agents, std::span<AgentState> states,
                      std::span<const std::size_t> which, double t_s, PullBlock block);

}  // namespace slackwater::twin
