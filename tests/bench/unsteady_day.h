#pragma once
#include <cstdint>
#include <vector>

#include "calibration/solve/calibration.h"
#include "calibration/solve/day_fit.h"

namespace slackwater::bench {

/// A column-day of the unsteady model with known truth: 24 hourly means x 35 levels over 150 m, 72
/// h of wind before it, two tide lines, twenty modes, 17 parameters, noise of 2 cm/s a component.
struct UnsteadyDay {
  calibration::CalibrationInput input;
  std::vector<double> truth;  ///< in the order of the layout, logarithms where so
};

[[nodiscard]] UnsteadyDay unsteady_day(std::uint64_t seed);

/// Its least-squares problem as calibrate_day poses it, but with plain squares.
[[nodiscard]] calibration::DayProblem plain_problem(const UnsteadyDay& day);

}  // namespace slackwater::bench
