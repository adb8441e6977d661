#include "calibration/skill/bootstrap.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "fields/base/check.h"
#include "fields/base/numbers/quantile.h"

namespace slackwater::calibration {
namespace {

constexpr double largest_autocorrelation = 0.8;
constexpr double normal_975 = 1.959963984540054;

double mean_of(std::span<const BlockSum> series) noexcept {
  BlockSum all;
  for (const BlockSum& member : series) {
    all.sum += member.sum;
    all.weight += member.weight;
  }
  return all.sum / all.weight;
}

/// Variance of the mean of n members of a first-order autoregression of unit variance.
double variance_of_mean(std::size_t n, double phi) noexcept {
  const auto count = static_cast<double>(n);
  double sum = 1.0;
  double power = 1.0;
  for (std::size_t k = 1; k < n; ++k) {
    power *= phi;
    sum += 2.0 * (1.0 - static_cast<double>(k) / count) * power;
  }
  return sum / count;
}

/// The 97.5 % quantile of Student's t with nu >= 2 degrees of freedom, within 4 %.
/// Source: Abramowitz and Stegun (1964), 26.7.5.
double student_975(double nu) noexcept {
  const double z = normal_975;
  const double z3 = z * z * z;
  const double z5 = z3 * z * z;
  const double z7 = z5 * z * z;
  return z + (z3 + z) / (4 * nu) + (5 * z5 + 16 * z3 + 3 * z) / (96 * nu * nu) +
         (3 * z7 + 19 * z5 + 17 * z3 - 15 * z) / (384 * nu * nu * nu);
}

/// By how much the departures of drawn means are too small.
double widening(std::size_t n, std::size_t length, double phi) noexcept {
  const double blocks = static_cast<double>(n) / static_cast<double>(length);
  const double variance = variance_of_mean(n, phi);
  // Blocks vary about the series' own mean, which follows them.
  const double drawn = (variance_of_mean(length, phi) - variance) / blocks;
  const double independent = std::min(1.0 / variance, blocks);
  return std::sqrt(variance / drawn) * student_975(std::max(2.0, independent - 1.0)) / normal_975;
}

/// The mean of blocks drawn around the circle until they are as many as the series.
double drawn_mean(std::span<const BlockSum> series, std::size_t length, Rng& random) {
  const std::size_t n = series.size();
  BlockSum drawn;
  for (std::size_t filled = 0; filled < n;) {
    const auto first = static_cast<std::size_t>(random.uniform() * static_cast<double>(n));
    for (std::size_t i = 0; i < length && filled < n; ++i, ++filled) {
      const BlockSum& member = series[(first + i) % n];
      drawn.sum += member.sum;
      drawn.weight += member.weight;
    }
  }
  return drawn.sum / drawn.weight;
}

}  // namespace

double lag_one_autocorrelation(std::span<const BlockSum> series) noexcept {
  if (series.size() < 2) return 0;
  const auto n = static_cast<double>(series.size());
  const double mean = mean_of(series);
  double variance = 0;
  double product = 0;
  double before = 0;
  double scale = 0;
  for (const BlockSum& member : series) {
    const double departure = member.sum - mean * member.weight;
    variance += departure * departure;
    product += before * departure;
    before = departure;
    scale += member.sum * member.sum;
  }
  if (variance <= 1e-24 * scale) return 0;
  const double found = product / variance;
  return std::clamp(found + (1.0 + 4.0 * found) / n, 0.0, largest_autocorrelation);
}

std::size_t block_length(std::size_t n, double autocorrelation) noexcept {
  const double phi = autocorrelation;
  const double best = std::pow(std::sqrt(6.0) * phi / (1.0 - phi * phi), 2.0 / 3.0) *
                      std::cbrt(static_cast<double>(n));
  return std::clamp<std::size_t>(static_cast<std::size_t>(std::lround(best)), 1,
                                 std::max<std::size_t>(1, n / 3));
}

std::optional<Interval95> bootstrap_mean(std::span<const BlockSum> series, Rng& random, int draws) {
  expects(draws >= 40, "an interval of 95 % needs at least 40 draws");
  std::vector<BlockSum> filled;
  for (const BlockSum& member : series)
    if (member.weight > 0) filled.push_back(member);
  if (filled.size() < fewest_for_interval) return std::nullopt;
  const double phi = lag_one_autocorrelation(filled);
  const std::size_t length = block_length(filled.size(), phi);
  std::vector<double> mean(static_cast<std::size_t>(draws));
  for (double& result : mean) result = drawn_mean(filled, length, random);
  std::sort(mean.begin(), mean.end());
  const double centre = mean_of(filled);
  const double wider = widening(filled.size(), length, phi);
  const auto quantile = [&](double share) {
    return centre + wider * (nearest_quantile(mean, share) - centre);
  };
  return Interval95{quantile(0.025), quantile(0.975)};
}

std::optional<Interval95> bootstrap_rms(std::span<const BlockSum> series, Rng& random, int draws) {
  const std::optional<Interval95> squares = bootstrap_mean(series, random, draws);
  if (!squares) return std::nullopt;
  return Interval95{std::sqrt(std::max(0.0, squares->low)), std::sqrt(squares->high)};
}

std::optional<Interval95> bootstrap_rmse(std::span<const double> squared_error,
                                         std::span<const std::size_t> member, Rng& random,
                                         int draws) {
  expects(squared_error.size() == member.size(), "one member of the series per value");
  std::map<std::size_t, BlockSum> by_number;
  for (std::size_t i = 0; i < member.size(); ++i) {
    BlockSum& sum = by_number[member[i]];
    sum.sum += squared_error[i];
    sum.weight += 1.0;
  }
  std::vector<BlockSum> series;
  series.reserve(by_number.size());
  for (const auto& [number, sum] : by_number) series.push_back(sum);
  return bootstrap_rms(series, random, draws);
}

}  // namespace slackwater::calibration
