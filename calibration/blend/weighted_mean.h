#pragma once
#include <span>

namespace slackwater::calibration {

/// A weighted mean with its standard error, the terms being correlated from one to the next.
struct WeightedMean {
  double mean = 0;
  double standard_error = 0;
  double independent = 0;  ///< number of independent terms that they are worth
};

/// Mean of x with weights g, oldest first.
///
///   n = (sum g)^2 / sum g^2 (1 - r)/(1 + r),   se^2 = weighted variance / (n - 1)
///
/// r: correlation of neighbours, between 0 and 0.9 (a negative one is not believed: it would only
/// flatter). Fewer than 1.5 independent terms, or fewer than two: n is 1 and se infinite.
/// Source: Kish (1965), Survey Sampling, sec. 11.7; Zwiers & von Storch (1995), J. Climate 8, 336.
[[nodiscard]] WeightedMean weighted_mean(std::span<const double> x, std::span<const double> g);

}  // namespace slackwater::calibration
