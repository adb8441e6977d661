#pragma once
#include <span>
#include <string>

#include "twin/run/set_up.h"

namespace slackwater::twin {

/// What the limits say of a start, read against the central forecast as a planner reads them:
/// nothing is flown.
struct LimitsSay {
  bool allows = true;
  /// "surveyor: current at most 0.5 m/s, forecast 0.66 m/s at 3 m of depth": nearest to its bound.
  std::string binding;
  double share = 0;  ///< how much of it is taken up; above 1: exceeded
};

/// Looks every ten minutes over the length of the mission, at the places of each phase
/// (`places_of`). Limits on what only a run can show (the motion of a deck) are left out, and what
/// nobody knows there.
/// @param workers  whose limits count; none: those of all
/// @throws Error(invalid_input) as `set_up`
[[nodiscard]] LimitsSay by_the_limits(const Scenario& mission, const Surround& surround,
                                      UtcTime start, std::span<const std::string> workers);

}  // namespace slackwater::twin
