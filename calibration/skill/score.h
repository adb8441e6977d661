#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "calibration/skill/bootstrap.h"
#include "calibration/skill/predictive.h"
#include "fields/base/frame.h"
#include "fields/base/numbers/random.h"

namespace slackwater::calibration {

/// How honest a spread is, components pooled: over many forecasts the truth should fall below a
/// quantile as often as the quantile says, and into each tenth of the distribution equally often.
struct Reliability {
  static constexpr std::array probability{0.05, 0.10, 0.25, 0.50, 0.75, 0.90, 0.95};
  static constexpr std::size_t pit_bins = 10;
  std::array<double, probability.size()> below{};  ///< share of truths below each quantile
  std::array<double, pit_bins> pit{};              ///< share of truths in each tenth; sums to one
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
  std::optional<Reliability> reliability;
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

/// Root mean square error of a set in which every pair of days weighs the same, whatever its number
/// of values; in the unit of what is given.
[[nodiscard]] double rmse_of_pairs(std::span<const double> pair_rmse);

/// What a set of vectors has beyond its error: means over the pairs that have the score.
struct VectorSetScore {
  double bias_east_m_s = 0;
  double bias_north_m_s = 0;
  double speed_bias_m_s = 0;
  std::optional<double> direction_mae_deg;
  std::optional<double> correlation_abs;  ///< of the mean complex correlation
  std::optional<double> correlation_deg;
  std::optional<double> crps_m_s;
  std::optional<double> coverage_80;
  std::optional<Interval95> coverage_interval;  ///< empty where the pairs that have one are few
  std::optional<Reliability> reliability;
};

/// A set of pairs of days (D, D+1), each of which weighs the same whatever its number of values.
/// Intervals come from drawing blocks of neighbouring pairs with replacement (`bootstrap_mean`):
/// the errors of one day are not independent of each other, nor quite of those of the day before.
struct SetScore {
  std::size_t pairs = 0;
  std::size_t n = 0;  ///< values in all pairs
  /// Root of the mean over pairs of the pair's mean squared error, in the unit of what was scored
  /// (`unit_of`): m/s for vectors, m for the height of waves.
  double rmse = 0;
  std::optional<Interval95> rmse_interval;  ///< in the same unit; empty where the pairs are few
  std::optional<double> bias;               ///< of scalars, in the same unit
  std::optional<VectorSetScore> vector;     ///< of vectors

  /// Too few pairs to claim an interval of.
  [[nodiscard]] bool is_of_few() const noexcept { return pairs < fewest_for_interval; }
};

/// Scores a set of vectors, pairs in the order of their days. Throws ContractViolation for no
/// pairs. Cost: draws x pairs.
[[nodiscard]] SetScore score_set(std::span<const VectorScore> pairs, Rng& random, int draws = 2000);
/// The same of scalars.
[[nodiscard]] SetScore score_set(std::span<const ScalarScore> pairs, Rng& random, int draws = 2000);

}  // namespace slackwater::calibration
