#include <algorithm>
#include <cmath>
#include <vector>

#include "calibration/skill/score.h"
#include "fields/base/check.h"
#include "fields/base/constants.h"

namespace slackwater::calibration {
namespace {

/// Mean of a score over the pairs that have it.
template <typename Score, typename Of>
std::optional<double> mean_over(std::span<const Score> pairs, Of of) {
  double sum = 0;
  double count = 0;
  for (const Score& pair : pairs) {
    const std::optional<double> value = of(pair);
    if (!value) continue;
    sum += *value;
    count += 1;
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

void set_correlation(std::span<const VectorScore> pairs, VectorSetScore& set) {
  Horizontal sum{};
  double count = 0;
  for (const VectorScore& pair : pairs) {
    if (!pair.correlation_abs || !pair.correlation_deg) continue;
    sum += std::polar(*pair.correlation_abs, *pair.correlation_deg * constants::pi / 180.0);
    count += 1;
  }
  if (count == 0) return;
  set.correlation_abs = std::abs(sum) / count;
  set.correlation_deg = std::arg(sum) * 180.0 / constants::pi;
}

void set_reliability(std::span<const VectorScore> pairs, VectorSetScore& set) {
  Reliability sum;
  double count = 0;
  for (const VectorScore& pair : pairs) {
    if (!pair.reliability) continue;
    for (std::size_t i = 0; i < sum.below.size(); ++i) sum.below[i] += pair.reliability->below[i];
    for (std::size_t i = 0; i < sum.pit.size(); ++i) sum.pit[i] += pair.reliability->pit[i];
    count += 1;
  }
  if (count == 0) return;
  for (double& share : sum.below) share /= count;
  for (double& share : sum.pit) share /= count;
  set.reliability = sum;
}

/// The error of a set and its interval.
/// @param rmse_of  the error of a pair
template <typename Score, typename Of>
SetScore set_error(std::span<const Score> pairs, Of rmse_of, Rng& random, int draws) {
  expects(!pairs.empty(), "a set has at least one pair");
  SetScore set;
  set.pairs = pairs.size();
  std::vector<BlockSum> squares;
  std::vector<double> rmse;
  for (const Score& pair : pairs) {
    set.n += pair.n;
    rmse.push_back(rmse_of(pair));
    squares.push_back({rmse.back() * rmse.back(), 1.0});
  }
  set.rmse = rmse_of_pairs(rmse);
  set.rmse_interval = bootstrap_rms(squares, random, draws);
  return set;
}

}  // namespace

SetScore score_set(std::span<const VectorScore> pairs, Rng& random, int draws) {
  using Score = const VectorScore&;
  SetScore set = set_error(
      pairs, [](Score s) { return s.rmse_m_s; }, random, draws);
  VectorSetScore& vector = set.vector.emplace();
  std::vector<BlockSum> coverage;
  for (const VectorScore& pair : pairs) {
    if (pair.coverage_80) coverage.push_back({*pair.coverage_80, 1.0});
  }
  vector.coverage_interval = bootstrap_mean(coverage, random, draws);
  if (vector.coverage_interval) {
    vector.coverage_interval->low = std::max(0.0, vector.coverage_interval->low);
    vector.coverage_interval->high = std::min(1.0, vector.coverage_interval->high);
  }
  vector.bias_east_m_s = *mean_over(pairs, [](Score s) { return std::optional(s.bias_east_m_s); });
  vector.bias_north_m_s =
      *mean_over(pairs, [](Score s) { return std::optional(s.bias_north_m_s); });
  vector.speed_bias_m_s =
      *mean_over(pairs, [](Score s) { return std::optional(s.speed_bias_m_s); });
  vector.direction_mae_deg = mean_over(pairs, [](Score s) { return s.direction_mae_deg; });
  vector.crps_m_s = mean_over(pairs, [](Score s) { return s.crps_m_s; });
  vector.coverage_80 = mean_over(pairs, [](Score s) { return s.coverage_80; });
  set_correlation(pairs, vector);
  set_reliability(pairs, vector);
  return set;
}

SetScore score_set(std::span<const ScalarScore> pairs, Rng& random, int draws) {
  using Score = const ScalarScore&;
  SetScore set = set_error(
      pairs, [](Score s) { return s.rmse; }, random, draws);
  set.bias = mean_over(pairs, [](Score s) { return std::optional(s.bias); });
  return set;
}

}  // namespace slackwater::calibration
