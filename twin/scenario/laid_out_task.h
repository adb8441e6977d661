#pragma once
#include <span>

#include "twin/scenario/scenario.h"

namespace slackwater::twin {

// Parts of a scenario that a mission or a survey is laid out into: numbers to the micrometre.

[[nodiscard]] double to_micrometre(double value) noexcept;
/// @param at_m  NED
[[nodiscard]] Triple<double> to_micrometre(const Triple<double>& at_m) noexcept;

[[nodiscard]] ScenarioTask route_task(std::span<const Waypoint> waypoints, Phase phase,
                                      bool drifts = false);
[[nodiscard]] ScenarioTask hold_task(double duration_s, Phase phase);
[[nodiscard]] ScenarioTask aboard_task(double duration_s, bool is_swapped, Phase phase);
/// Aboard for at least so long, until its carrier stands by; and what that carrier does.
[[nodiscard]] ScenarioTask carried_task(double least_s, bool is_swapped);
[[nodiscard]] ScenarioTask stand_by_task();

}  // namespace slackwater::twin
