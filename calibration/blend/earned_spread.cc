#include "calibration/blend/earned_spread.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fields/base/check.h"
#include "fields/base/text.h"

namespace slackwater::calibration {
namespace {

constexpr double wanted = 0.8;
constexpr double z_of_80_percent = 1.2815515655446004;  ///< 90 % quantile of the standard normal

using Histogram = std::array<double, NormalisedErrors::bins + 1>;

double edge(std::size_t bin) noexcept {
  return static_cast<double>(bin) * NormalisedErrors::bin_width;
}

/// Of |z| for a standard normal z.
Histogram of_normal() {
  Histogram shares{};
  double below = 0;
  for (std::size_t bin = 0; bin < NormalisedErrors::bins; ++bin) {
    const double up_to = std::erf(edge(bin + 1) / std::numbers::sqrt2);
    shares[bin] = up_to - below;
    below = up_to;
  }
  shares.back() = 1.0 - below;
  return shares;
}

void add(Histogram& sum, const NormalisedErrors& errors, double weight) {
  for (std::size_t bin = 0; bin < sum.size(); ++bin) sum[bin] += weight * errors.share(bin);
}

double total(const Histogram& histogram) {
  double sum = 0;
  for (const double share : histogram) sum += share;
  return sum;
}

/// The |z| below which a share lies, linear within bins; the end of the last bin where it is
/// beyond.
double quantile(const Histogram& histogram, double share) {
  const double target = share * total(histogram);
  double below = 0;
  for (std::size_t bin = 0; bin < NormalisedErrors::bins; ++bin) {
    if (histogram[bin] > 0 && below + histogram[bin] >= target) {
      return edge(bin) + NormalisedErrors::bin_width * (target - below) / histogram[bin];
    }
    below += histogram[bin];
  }
  return edge(NormalisedErrors::bins);
}

double share_below(const Histogram& histogram, double z) {
  double below = 0;
  for (std::size_t bin = 0; bin < NormalisedErrors::bins; ++bin) {
    below += histogram[bin] * std::clamp((z - edge(bin)) / NormalisedErrors::bin_width, 0.0, 1.0);
  }
  return below / total(histogram);
}

std::string provenance_of(const EarnedSpread& spread, const SpreadSettings& settings) {
  if (spread.pairs == 0) return "spread as forecast: no past pair has verified it";
  return formatted(
      "spread times {:.2f}: over {} past pair{} the 80 % band held {:.0f} % of the truth (averaged "
      "with {:.3g} pairs in which it would hold 80 %)",
      spread.scale, spread.pairs, spread.pairs == 1 ? "" : "s", 100.0 * spread.past_coverage_80,
      settings.prior_pairs);
}

}  // namespace

void NormalisedErrors::add(double error, double sigma) noexcept {
  if (!std::isfinite(error) || !std::isfinite(sigma) || sigma < 0) return;
  const double size = std::abs(error);
  const double last = edge(bins) * sigma;
  std::size_t bin = bins;
  if (size == 0.0) {
    bin = 0;
  } else if (size < last) {
    bin = std::min(bins, static_cast<std::size_t>(size / sigma / bin_width));
  }
  in_bin_[bin] += 1.0;
  total_ += 1.0;
}

double NormalisedErrors::share(std::size_t bin) const noexcept {
  return total_ > 0 ? in_bin_[bin] / total_ : 0.0;
}

EarnedSpread earned_spread(std::span<const PastSpread> past, const SpreadSettings& settings) {
  expects(settings.forgetting_days > 0 && settings.prior_pairs >= 0 && settings.least > 0 &&
              settings.least <= settings.most,
          "an earned spread forgets in a positive time and has bounds in order");
  EarnedSpread result;
  Histogram seen{};
  for (const PastSpread& pair : past) {
    expects(pair.age_days >= 0, "a past pair is not younger than the day that is forecast from");
    if (pair.errors.count() <= 0) continue;
    ++result.pairs;
    add(seen, pair.errors, std::exp(-pair.age_days / settings.forgetting_days));
  }
  if (result.pairs > 0 && total(seen) > 0) {
    result.past_coverage_80 = share_below(seen, z_of_80_percent);
    const Histogram believed = of_normal();
    for (std::size_t bin = 0; bin < seen.size(); ++bin) {
      seen[bin] += settings.prior_pairs * believed[bin];
    }
    result.scale =
        std::clamp(quantile(seen, wanted) / z_of_80_percent, settings.least, settings.most);
  }
  result.provenance = provenance_of(result, settings);
  return result;
}

}  // namespace slackwater::calibration
