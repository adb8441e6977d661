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
constexpr double passage_h = 6.0;  ///< from the factor of one day of lead to the next day's

using Histogram = std::array<double, NormalisedErrors::bins + 1>;

double edge(std::size_t bin) noexcept {
  return static_cast<double>(bin) * NormalisedErrors::bin_width;
}

/// Of |z| for a normal z.
Histogram of_normal(double sigma) {
  Histogram shares{};
  double below = 0;
  for (std::size_t bin = 0; bin < NormalisedErrors::bins; ++bin) {
    const double up_to = std::erf(edge(bin + 1) / sigma / std::numbers::sqrt2);
    shares[bin] = up_to - below;
    below = up_to;
  }
  shares.back() = 1.0 - below;
  return shares;
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

/// What one day of lead has met.
struct Seen {
  Histogram sum{};
  std::size_t pairs = 0;

  void add(const NormalisedErrors& errors, double weight) {
    if (errors.count() <= 0) return;
    ++pairs;
    for (std::size_t bin = 0; bin < sum.size(); ++bin) sum[bin] += weight * errors.share(bin);
  }
  [[nodiscard]] bool is_empty() const { return pairs == 0 || !(total(sum) > 0); }
};

/// @param before  the factor that is believed before any pair
LaterSpread earned_of(const Seen& seen, double before, const SpreadSettings& settings) {
  LaterSpread earned;
  earned.scale = before;
  earned.pairs = seen.pairs;
  if (seen.is_empty()) return earned;
  earned.past_coverage_80 = share_below(seen.sum, z_of_80_percent);
  Histogram all = seen.sum;
  const Histogram believed = of_normal(before);
  for (std::size_t bin = 0; bin < all.size(); ++bin)
    all[bin] += settings.prior_pairs * believed[bin];
  earned.scale = std::clamp(quantile(all, wanted) / z_of_80_percent, settings.least, settings.most);
  return earned;
}

std::string provenance_of(const EarnedSpread& spread, const SpreadSettings& settings) {
  if (spread.pairs == 0) return "spread as forecast: no past pair of days has checked it yet";
  std::string sentence = formatted(
      "spread times {:.2f}: in {} past pair{} of days the 80 % band held {:.0f} % of the truth "
      "(averaged with {:.3g} assumed pairs of 80 %)",
      spread.scale, spread.pairs, spread.pairs == 1 ? "" : "s", 100.0 * spread.past_coverage_80,
      settings.prior_pairs);
  for (std::size_t day = 0; day < spread.later.size(); ++day) {
    if (spread.later[day].pairs == 0) continue;
    sentence +=
        formatted("; times {:.2f} on day {} of lead ({} pair{}, {:.0f} %)", spread.later[day].scale,
                  day + 2, spread.later[day].pairs, spread.later[day].pairs == 1 ? "" : "s",
                  100.0 * spread.later[day].past_coverage_80);
  }
  return sentence;
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
  std::vector<Seen> seen(1);
  for (const PastSpread& pair : past) {
    expects(pair.age_days >= 0, "a past pair is not younger than the day that is forecast from");
    const double weight = std::exp(-pair.age_days / settings.forgetting_days);
    seen.resize(std::max(seen.size(), 1 + pair.later.size()));
    seen.front().add(pair.errors, weight);
    for (std::size_t day = 0; day < pair.later.size(); ++day)
      seen[1 + day].add(pair.later[day], weight);
  }
  EarnedSpread result;
  const LaterSpread first = earned_of(seen.front(), 1.0, settings);
  result.scale = first.scale;
  result.pairs = first.pairs;
  result.past_coverage_80 = first.past_coverage_80;
  for (std::size_t day = 1; day < seen.size(); ++day) {
    const double before = day == 1 ? result.scale : result.later.back().scale;
    result.later.push_back(earned_of(seen[day], before, settings));
  }
  result.provenance = provenance_of(result, settings);
  return result;
}

double EarnedSpread::scale_at(double lead_h) const noexcept {
  double at = scale;
  for (std::size_t day = 0; day < later.size(); ++day) {
    const double end_h = 24.0 * static_cast<double>(day + 1);
    const double passed = std::clamp((lead_h - end_h + 0.5 * passage_h) / passage_h, 0.0, 1.0);
    const double before = day == 0 ? scale : later[day - 1].scale;
    at += passed * (later[day].scale - before);
  }
  return at;
}

}  // namespace slackwater::calibration
