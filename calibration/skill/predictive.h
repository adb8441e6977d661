#pragma once

namespace slackwater::calibration {

/// How one component of a probabilistic forecast met its truth. Every score of a spread (CRPS,
/// coverage, reliability, the PIT histogram) is made from this and nothing else, so that a forecast
/// that carries members or quantiles needs one more function here and no other change.
struct ComponentScore {
  double probability_below = 0.5;  ///< forecast probability of a value below the truth (PIT)
  double crps = 0;                 ///< continuous ranked probability score, unit of the component
};

/// The score of a normal forecast. A forecast without spread (sigma 0) puts the truth wholly below
/// or above itself, or in its middle where they are equal.
[[nodiscard]] ComponentScore score_of_normal(double mean, double sigma, double truth) noexcept;

/// Continuous ranked probability score of a normal forecast, in the unit of its mean:
///
///   CRPS = sigma { z [2 Phi(z) - 1] + 2 phi(z) - 1/sqrt(pi) },  z = (x - mu)/sigma
///        = |x - mu|  for sigma = 0
///
/// Source: Gneiting et al. (2005), Monthly Weather Review 133, 1098, eq. 5.
[[nodiscard]] double normal_crps(double mean, double sigma, double truth) noexcept;

}  // namespace slackwater::calibration
