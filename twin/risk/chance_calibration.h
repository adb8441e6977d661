#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace slackwater::twin {

/// What was said of a start on a past morning, and what came.
struct PastStart {
  double said = 0;  ///< that all limits hold, as the futures have it
  bool held = false;
};
/// Of one morning, in order.
using PastStarts = std::vector<PastStart>;

/// What past mornings make of a probability that the futures of a forecast give:
///
///   logit P' = a + b logit P,   b >= 0
///
/// which keeps the order of starts. a and b are the likeliest under what is believed beforehand, a
/// ~ N(0, 0.7) and b ~ N(1, 0.2): without past mornings P' is P. The starts of a morning share its
/// weather: together they count as two, for errors of forecasts last half a day.
/// Source: Platt (1999), Advances in Large Margin Classifiers; Wilks (2011), Statistical Methods in
/// the Atmospheric Sciences, section 7.4 (logistic recalibration).
struct ChanceCalibration {
  double shift = 0;  ///< a
  double slope = 1;  ///< b
  std::size_t mornings = 0;
  std::size_t starts = 0;  ///< of these mornings
  double said = 0;         ///< the mean of what was said of them
  double held = 0;         ///< the share of them that held

  [[nodiscard]] double operator()(double probability) const noexcept;
};

/// @param mornings  of one task; those without a start count for nothing
[[nodiscard]] ChanceCalibration chance_calibration(std::span<const PastStarts> mornings);

}  // namespace slackwater::twin
