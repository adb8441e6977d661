#pragma once
#include <string>
#include <vector>

#include "calibration/residuals/level_velocity.h"
#include "calibration/solve/calibration.h"

namespace slackwater::calibration {

/// What of a day can be fitted.
struct Observations {
  std::vector<double> depth_m;  ///< all levels of the column
  double water_depth_m = 0;     ///< as given, or the deepest level with a value
  bool wind_used = false;
  std::vector<LevelVelocity> pairs;     ///< by time, then level
  std::vector<std::size_t> time_index;  ///< of each pair, in the column
  std::vector<std::string> warnings;    ///< what was left out, and why
};

/// Pairs every current that has a value with the wind stress of its instant or interval.
/// Throws Error(invalid_input) where nothing is left to fit.
[[nodiscard]] Observations pair_observations(const CalibrationInput& input);

}  // namespace slackwater::calibration
