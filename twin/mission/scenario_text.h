#pragma once
#include <optional>
#include <set>
#include <span>
#include <string>

#include "fields/base/config.h"
#include "twin/control/route.h"
#include "twin/mission/phase.h"

namespace slackwater::twin {

// Parts of a scenario as YAML: what a mission is laid out into.

/// To the micrometre.
[[nodiscard]] std::string number_text(double value);
/// "north_m: 1, east_m: 2, depth_m: 3". @param at_m  NED
[[nodiscard]] std::string place_text(const Triple<double>& at_m);

// Tasks, each a line of the list.
[[nodiscard]] std::string route_text(std::span<const Waypoint> waypoints, Phase phase,
                                     bool drifts = false);
[[nodiscard]] std::string hold_text(double duration_s, Phase phase);
[[nodiscard]] std::string aboard_text(double duration_s, bool is_swapped, Phase phase);
/// Aboard for at least so long, until its carrier stands by; and what that carrier does.
[[nodiscard]] std::string carried_text(double least_s, bool is_swapped);
[[nodiscard]] std::string stand_by_text();

/// Keys of a mapping with what stands in another put in their place, as YAML on one line.
[[nodiscard]] std::string merged(const std::optional<Config>& base,
                                 const std::optional<Config>& over,
                                 const std::set<std::string>& left_out = {});

}  // namespace slackwater::twin
