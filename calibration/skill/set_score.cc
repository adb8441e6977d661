#include <cmath>
#include <vector>

#include "calibration/skill/score.h"
#include "fields/base/check.h"
#include "fields/base/constants.h"

namespace slackwater::calibration {
namespace {

/// Mean of a score over the pairs that have it.
template <typename Of>
std::optional<double> mean_over(std::span<const VectorScore> pairs, Of of) {
  double sum = 0;
  double count = 0;
  for (const VectorScore& pair : pairs) {
    const std::optional<double> value = of(pair);
    if (!value) continue;
    sum += *value;
    count += 1;
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

void set_correlation(std::span<const VectorScore> pairs, SetScore& set) {
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

void set_reliability(std::span<const VectorScore> pairs, SetScore& set) {
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

}  // namespace

SetScore score_set(std::span<const VectorScore> pairs, Rng& random, int draws) {
  expects(!pairs.empty(), "a set has at least one pair");
  SetScore set;
  set.pairs = pairs.size();
  std::vector<BlockSum> squares;
  std::vector<BlockSum> coverage;
  for (const VectorScore& pair : pairs) {
    set.n += pair.n;
    squares.push_back({pair.rmse_m_s * pair.rmse_m_s, 1.0});
    if (pair.coverage_80) coverage.push_back({*pair.coverage_80, 1.0});
  }
  std::vector<double> rmse;
  for (const VectorScore& pair : pairs) rmse.push_back(pair.rmse_m_s);
  set.rmse_m_s = rmse_of_pairs(rmse);
  set.rmse_interval_m_s = bootstrap_rms(squares, random, draws);
  set.coverage_interval = bootstrap_mean(coverage, random, draws);
  using Score = const VectorScore&;
  set.bias_east_m_s = *mean_over(pairs, [](Score s) { return std::optional(s.bias_east_m_s); });
  set.bias_north_m_s = *mean_over(pairs, [](Score s) { return std::optional(s.bias_north_m_s); });
  set.speed_bias_m_s = *mean_over(pairs, [](Score s) { return std::optional(s.speed_bias_m_s); });
  set.direction_mae_deg = mean_over(pairs, [](Score s) { return s.direction_mae_deg; });
  set.crps_m_s = mean_over(pairs, [](Score s) { return s.crps_m_s; });
  set.coverage_80 = mean_over(pairs, [](Score s) { return s.coverage_80; });
  set_correlation(pairs, set);
  set_reliability(pairs, set);
  return set;
}

}  // namespace slackwater::calibration
