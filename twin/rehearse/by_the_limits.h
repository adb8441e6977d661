#pragma once
#include <span>
#include <string>

#include "twin/simulate/set_up.h"

namespace slackwater::twin {

/// What the limits say of a start, read against the central forecast as a planner reads them:
/// nothing is flown.
struct LimitsSay {
  bool allows = true;
  std::string
      binding;  ///< "surveyor: current at most 0.5 m/s at 31.2 m", the limit nearest to its bound
  double share = 0;  ///< how much of it is taken up; above 1: exceeded
};

/// Looks every ten minutes over the length of the mission, at the place of each phase
/// (`places_in`). Limits on what only a run can show (the motion of a deck) are left out.
/// @param workers  whose limits count; none: those of all
/// @throws Error(invalid_input) as `set_up`
[[nodiscard]] LimitsSay by_the_limits(const Scenario& mission, const Surround& surround,
                                      UtcTime start, std::span<const std::string> workers);

}  // namespace slackwater::twin
