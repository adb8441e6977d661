#pragma once
#include <cstddef>
#include <optional>
#include <span>

#include "fields/base/frame.h"
#include "fields/base/random.h"

namespace slackwater::calibration {

/// Both ends of an interval.
struct Interval95 {
  double low = 0;
  double high = 0;
};

/// How a vector forecast did. What cannot be said (no spread in the data, no sigma, calm truth) is
/// empty.
struct VectorScore {
  std::size_t n = 0;         ///< pairs of vectors
  double rmse_m_s = 0;       ///< sqrt of mean |forecast - truth|^2, of the vector
  double bias_east_m_s = 0;  ///< forecast - truth
  double bias_north_m_s = 0;
  double speed_bias_m_s = 0;  ///< mean of |forecast| - |truth|
  std::optional<double>
      direction_mae_deg;  ///< smallest angle, over pairs where both exceed 0.05 m/s
  /// Complex correlation of the departures from the means (Kundu 1976): its modulus, and the angle
  /// by which the truth lies counter-clockwise of the forecast.
  std::optional<double> correlation_abs;
  std::optional<double> correlation_deg;
  std::optional<double> crps_m_s;     ///< pooled over the two components
  std::optional<double> coverage_80;  ///< share of components inside the central 80 % band
};

/// Scores pairs; all weigh the same.
///
/// @param sigma_m_s  standard deviation of each component of each forecast, or empty
/// Throws ContractViolation for no pairs, unlike lengths or a negative sigma.
[[nodiscard]] VectorScore score_vectors(std::span<const Horizontal> forecast,
                                        std::span<const Horizontal> truth,
                                        std::span<const double> sigma_m_s = {});

/// How a scalar forecast (wind speed, wave height) did, in its own unit.
struct ScalarScore {
  std::size_t n = 0;
  double rmse = 0;
  double bias = 0;  ///< forecast - truth
  double mae = 0;
  /// Standard deviation of forecast - truth over the mean of the truth; empty where that mean is
  /// not positive.
  std::optional<double> scatter_index;
};
[[nodiscard]] ScalarScore score_scalars(std::span<const double> forecast,
                                        std::span<const double> truth);

/// Continuous ranked probability score of a normal forecast, in the unit of its mean:
///
///   CRPS = sigma { z [2 Phi(z) - 1] + 2 phi(z) - 1/sqrt(pi) },  z = (x - mu)/sigma;  |x - mu| for
///   sigma = 0
///
/// Source: Gneiting et al. (2005), Monthly Weather Review 133, 1098, eq. 5.
[[nodiscard]] double normal_crps(double mean, double sigma, double truth) noexcept;

/// Root mean square error of a set in which every pair of days weighs the same, whatever its number
/// of values.
[[nodiscard]] double rmse_of_pairs(std::span<const double> pair_rmse_m_s);

/// 95 % interval of the root mean square error by a block bootstrap: whole blocks (a day pair, say)
/// are drawn with replacement, since errors within one are not independent.
///
/// @param squared_error  per value
/// @param block          id of the block of each value; any numbers
/// @return empty for fewer than two blocks
[[nodiscard]] std::optional<Interval95> bootstrap_rmse(std::span<const double> squared_error,
                                                       std::span<const std::size_t> block,
                                                       Rng& random, int draws = 2000);

}  // namespace slackwater::calibration
