#pragma once
#include "twin/step/step_kernel.h"

namespace slackwater::twin {

/// What all numbers of a state, thrusters and battery too, come to when each is taken none times:
/// 0, or NaN where one of them is infinite or no number. A sum without a branch, so that eight
/// vehicles cost little more than one.
[[nodiscard]] inline double doubt_of(const VehicleState<double>& state) noexcept {
  constexpr std::size_t numbers = sizeof state / sizeof(double);
  const auto* number = reinterpret_cast<const double*>(&state);
  double doubt = 0;
  for (std::size_t i = 0; i < numbers; ++i) doubt += 0 * number[i];
  return doubt;
}
/// The same of each vehicle in a block.
[[nodiscard]] inline Eight doubt_of(const VehicleState<Eight>& block) noexcept {
  constexpr std::size_t numbers = sizeof block / sizeof(Eight);
  const auto* number = reinterpret_cast<const Eight*>(&block);
  Eight doubt{};
  for (std::size_t i = 0; i < numbers; ++i)
    for (std::size_t lane = 0; lane < block_lanes; ++lane)
      doubt.lane[lane] += 0 * number[i].lane[lane];
  return doubt;
}

}  // namespace slackwater::twin
