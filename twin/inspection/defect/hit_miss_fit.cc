#include "twin/inspection/defect/hit_miss_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/base/check.h"

namespace slackwater::twin {
namespace {

constexpr double deviations = 1.959963984540054;

/// Whether hits and misses overlap in size: else there is no greatest likelihood.
bool is_mixed(std::span<const HitMiss> looks) {
  double least_hit = std::numeric_limits<double>::infinity(), most_hit = 0;
  double least_miss = least_hit, most_miss = 0;
  for (const HitMiss& look : looks) {
    double& least = look.is_found ? least_hit : least_miss;
    double& most = look.is_found ? most_hit : most_miss;
    least = std::min(least, look.size);
    most = std::max(most, look.size);
  }
  return most_miss > least_hit && most_hit > least_miss;
}

/// Sums over the looks at one pair (slope b, level g of logit p = b x + g), x the logarithm less
/// its mean.
struct Information {
  double of_b = 0, of_g = 0;      ///< slope of the likelihood
  double bb = 0, bg = 0, gg = 0;  ///< information
  double log_likelihood = 0;

  Information(std::span<const HitMiss> looks, double mean, double b, double g) {
    for (const HitMiss& look : looks) {
      const double x = std::log(look.size) - mean, logit = b * x + g;
      const double p = 1 / (1 + std::exp(-logit));
      const double off = (look.is_found ? 1 : 0) - p, weight = p * (1 - p);
      of_b += off * x;
      of_g += off;
      bb += weight * x * x;
      bg += weight * x;
      gg += weight;
      // ln p or ln(1 - p), without loss where p is near 0 or 1.
      log_likelihood -= std::log1p(std::exp(look.is_found ? -logit : logit));
    }
  }
  [[nodiscard]] double determinant() const noexcept { return bb * gg - bg * bg; }
};

Within95 spread_of(double value, double sd) {
  return {value, value - deviations * sd, value + deviations * sd};
}
Within95 powers(const Within95& logs) {
  return {std::exp(logs.value), std::exp(logs.low), std::exp(logs.high)};
}

}  // namespace

std::optional<HitMissFit> fit_hit_miss(std::span<const HitMiss> looks) {
  for (const HitMiss& look : looks) expects(look.size > 0, "a size that was looked for is above 0");
  if (!is_mixed(looks)) return std::nullopt;
  double mean = 0;
  for (const HitMiss& look : looks) mean += std::log(look.size) / static_cast<double>(looks.size());

  double b = 0, g = 0;
  for (int step = 0; step < 100; ++step) {
    const Information here(looks, mean, b, g);
    if (!(here.determinant() > 0)) return std::nullopt;
    double to_b = (here.gg * here.of_b - here.bg * here.of_g) / here.determinant();
    double to_g = (here.bb * here.of_g - here.bg * here.of_b) / here.determinant();
    // The likelihood has one summit: a step that goes down went too far.
    while (Information(looks, mean, b + to_b, g + to_g).log_likelihood < here.log_likelihood &&
           std::abs(to_b) + std::abs(to_g) > 1e-12) {
      to_b *= 0.5;
      to_g *= 0.5;
    }
    b += to_b;
    g += to_g;
    if (std::abs(to_b) + std::abs(to_g) < 1e-12) break;
  }
  if (!(b > 0)) return std::nullopt;

  const Information best(looks, mean, b, g);
  const double var_b = best.gg / best.determinant(), var_g = best.bb / best.determinant();
  const double covariance = -best.bg / best.determinant();
  // ln a of logit L is mean + (L - g) / b.
  const auto log_size_at = [&](double logit) {
    const double from_b = -(logit - g) / (b * b), from_g = -1 / b;
    const double variance =
        from_b * from_b * var_b + 2 * from_b * from_g * covariance + from_g * from_g * var_g;
    return spread_of(mean + (logit - g) / b, std::sqrt(variance));
  };
  HitMissFit fit;
  fit.x0 = powers(log_size_at(0));
  fit.a90 = powers(log_size_at(std::log(9.0)));
  fit.b = spread_of(b, std::sqrt(var_b));
  fit.curve = {fit.x0.value, b};
  fit.looks = looks.size();
  fit.hits = static_cast<std::size_t>(
      std::count_if(looks.begin(), looks.end(), [](const HitMiss& look) { return look.is_found; }));
  return fit;
}

}  // namespace slackwater::twin
