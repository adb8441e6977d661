#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "twin/handling/trial.h"
#include "twin/vehicle/vehicle.h"

namespace slackwater::twin {

/// What a vehicle of ours did, told what the one of a trial was told.
struct TrialRun {
  std::size_t rows = 0;  ///< of the trial that it came to: all, unless it diverged
  /// Of each measured column of the trial, in its order, as many values as `rows`; SI, never NaN.
  std::vector<std::vector<double>> ours;
  double ended_at_s = 0;  ///< of the trial's clock: its last row, or where it diverged
  [[nodiscard]] bool diverged(const Trial& trial) const noexcept { return rows < trial.rows(); }
};

/// The most steps that a trial may take: 13.9 h at 0.05 s.
inline constexpr double most_trial_steps = 1e6;

/// Flies a vehicle open loop through the commands of a trial, without an autopilot, waves or wind,
/// in steps of at most its largest, on its usual bus voltage (own_autopilot.h).
///
/// It begins as the first row has it; what that row does not say is 0. Without `u` a `speed` is
/// ahead. What floats begins afloat; what swims as deep as `first_depth_m`, else as the row's
/// `down`, else 1000 m deep, where it feels nothing of the surface. Its `down` then counts from the
/// trial's first. Thrusters and fins stand as the first row commands them, so that a trial under
/// way begins under way; one from rest has a first row of noughts. So does ballast.
///
/// @param trial  of this vehicle's channels; two rows at least, times rising
/// @throws Error(invalid_input) for a multirotor, which falls without its controller; a trial of
/// more steps than `most_trial_steps`
/// Thread-safe. Cost: about 2 us a step.
[[nodiscard]] TrialRun replayed(const Vehicle& vehicle, const Trial& trial);

}  // namespace slackwater::twin
