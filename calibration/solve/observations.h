#pragma once
#include <string>
#include <vector>

#include "calibration/solve/calibration.h"
#include "fields/current/stress_series.h"

namespace slackwater::calibration {

/// One observed current, as a place in the day's times and levels.
struct Pair {
  Horizontal observed_m_s{};
  std::size_t time = 0;
  std::size_t level = 0;
  /// Of its error, in units of the day's: sqrt((s^2 + n_i^2)/(s^2 + mean n^2)), s the sigma at best
  /// and n the stated noise. 1 where none is stated, or all alike.
  double relative_sigma = 1;
};

/// What of a day can be fitted.
struct Observations {
  std::vector<double> depth_m;  ///< all levels of the column
  double water_depth_m = 0;     ///< as given, or the deepest level with a value
  bool wind_used = false;
  double noise_m_s = 0;               ///< root mean square of the stated noise over the pairs
  std::vector<Pair> pairs;            ///< by time, then level
  std::vector<Horizontal> stress_pa;  ///< of each time of the column; 0 where not used
  StressSeries stress;                ///< the wind's, empty where none is used
  std::vector<std::string> warnings;  ///< what was left out, and why
};

/// Pairs every current that has a value with the wind stress of its instant or interval.
/// Throws Error(invalid_input) where nothing is left to fit.
[[nodiscard]] Observations pair_observations(const CalibrationInput& input);

}  // namespace slackwater::calibration
