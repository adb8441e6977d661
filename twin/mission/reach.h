#pragma once
#include "fields/base/config.h"

namespace slackwater::twin {

// How far a run goes from its origin: what readers of scenarios and missions hold places to.

inline constexpr double farthest_m = 50e3;
inline constexpr Range within_reach_m{-farthest_m, farthest_m};  ///< north, and east
inline constexpr Range reached_depth_m{0, 12000};
inline constexpr Range reached_height_m{0, 1000};
inline constexpr Range cylinder_diameter_m{0.1, 100};
inline constexpr Range structure_height_m{-12000, 500};  ///< of its top
inline constexpr std::size_t most_waypoints = 100000;

}  // namespace slackwater::twin
