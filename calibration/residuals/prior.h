#pragma once

namespace slackwater::calibration {

/// What was known of one parameter before the day was seen.
///
/// Residual r = (x - mean)/sigma, one number; whitened by the standard deviation of the prior,
/// which comes from the literature named in calibration/solve/parameter_set.cc. For a positive
/// quantity x is its natural logarithm.
struct Prior {
  double mean = 0;
  double sigma = 1;  ///< > 0

  [[nodiscard]] double residual(double x) const noexcept { return (x - mean) / sigma; }
  /// dr/dx
  [[nodiscard]] double derivative() const noexcept { return 1.0 / sigma; }
};

}  // namespace slackwater::calibration
