#pragma once
#include <algorithm>

#include "twin/control/autopilot.h"

namespace slackwater::twin {

/// How much of what its thrusters can push a vehicle asks of them: that of the most used one,
/// averaged over some seconds, since a push that lasts no longer is none that it lacks. Numbers
/// only.
struct ThrustUse {
  double now = 0;   ///< 0 to 1
  double most = 0;  ///< so far; what is left of 1 is the margin
};

inline constexpr double thrust_memory_s = 10;

inline void note_thrust(const Allocation& allocation, const Effort& effort, double dt_s,
                        ThrustUse& use) noexcept {
  double share = 0;
  for (std::size_t i = 0; i < allocation.mounts; ++i) {
    const double thrust_n = effort.thrust_n[i];
    const double can_n = thrust_n < 0 ? allocation.least_n[i] : allocation.most_n[i];
    if (can_n != 0) share = std::max(share, thrust_n / can_n);
  }
  use.now += std::min(dt_s / thrust_memory_s, 1.0) * (share - use.now);
  use.most = std::max(use.most, use.now);
}

}  // namespace slackwater::twin
