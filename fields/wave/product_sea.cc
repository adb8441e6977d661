#include "fields/wave/product_sea.h"

#include <cmath>

#include "fields/base/text.h"
#include "fields/wave/growth.h"

namespace slackwater {
namespace {

/// A height at the limit, worked out elsewhere, may pass it by rounding alone.
constexpr double rounding_allowance = 1.0 + 1e-9;

bool is_calm_or_absent(const WavePartition& p) {
  return p.significant_height_m == 0 ||
         (std::isnan(p.significant_height_m) && std::isnan(p.peak_period_s));
}

bool is_usable(const WavePartition& p) {
  return p.significant_height_m > 0 && std::isfinite(p.significant_height_m) &&
         p.peak_period_s > 0 && std::isfinite(p.peak_period_s) &&
         std::isfinite(p.from_direction_deg);
}

ServedSea lowered_to_limits(std::span<const WavePartition> partitions) {
  ServedSea served;
  for (std::size_t i = 0; i < partitions.size(); ++i) {
    WavePartition p = partitions[i];
    if (!is_usable(p)) {
      if (!is_calm_or_absent(p)) {
        served.warnings.push_back(formatted(
            "wave partition {} left out: Hs {:g} m, Tp {:g} s, from {:g} degrees is not a sea",
            i + 1, p.significant_height_m, p.peak_period_s, p.from_direction_deg));
      }
      continue;
    }
    const double limit_m = steepest_height_m(p.peak_period_s);
    if (p.significant_height_m > limit_m * rounding_allowance) {
      served.warnings.push_back(
          formatted("wave partition {}: Hs {:.3g} m with Tp {:.3g} s is steeper than waves can be "
                    "({:.3f}, limit {:.3f}); lowered to {:.3g} m",
                    i + 1, p.significant_height_m, p.peak_period_s,
                    steepness_of(p.significant_height_m, p.peak_period_s),
                    steepness_of(limit_m, p.peak_period_s), limit_m));
      p.significant_height_m = limit_m;
    }
    served.sea.partitions.push_back(p);
  }
  return served;
}

void scale_heights(PartitionedSea& sea, double factor) {
  for (WavePartition& p : sea.partitions) p.significant_height_m *= factor;
}

/// Raises the partitions in proportion to the total, each at most to its limit. Returns whether the
/// total was reached. Every round but the last puts one more partition at its limit.
bool raise_within_limits(PartitionedSea& sea, double total_m) {
  std::vector<bool> full(sea.partitions.size(), false);
  for (std::size_t round = 0; round <= sea.partitions.size(); ++round) {
    double held = 0;
    double free = 0;
    for (std::size_t i = 0; i < full.size(); ++i) {
      const double height = sea.partitions[i].significant_height_m;
      (full[i] ? held : free) += height * height;
    }
    if (free <= 0) return false;
    const double factor = std::sqrt((total_m * total_m - held) / free);
    bool any_filled = false;
    for (std::size_t i = 0; i < full.size(); ++i) {
      if (full[i]) continue;
      WavePartition& p = sea.partitions[i];
      const double limit_m = steepest_height_m(p.peak_period_s);
      if (p.significant_height_m * factor > limit_m) {
        p.significant_height_m = limit_m;
        full[i] = any_filled = true;
      }
    }
    if (any_filled) continue;
    for (std::size_t i = 0; i < full.size(); ++i) {
      if (!full[i]) sea.partitions[i].significant_height_m *= factor;
    }
    return true;
  }
  return false;
}

void rescale_to_total(ServedSea& served, double total_m) {
  const double sum_m = served.sea.significant_height_m();
  if (std::abs(sum_m - total_m) > 0.02 * total_m) {
    served.warnings.push_back(formatted(
        "wave partitions, {:.3g} m together, scaled to the total of {:.3g} m", sum_m, total_m));
  }
  if (total_m <= sum_m) {
    scale_heights(served.sea, total_m / sum_m);
  } else if (!raise_within_limits(served.sea, total_m)) {
    scale_heights(served.sea, total_m / served.sea.significant_height_m());
    served.warnings.push_back(
        formatted("the total sea of Hs {:.3g} m is steeper than its partitions allow; it is used "
                  "as the product gives it",
                  total_m));
  }
}

}  // namespace

ServedSea product_sea(double total_height_m, std::span<const WavePartition> partitions) {
  ServedSea served = lowered_to_limits(partitions);
  const double sum_m = served.sea.significant_height_m();
  if (sum_m > 0 && std::isfinite(total_height_m) && total_height_m >= 0) {
    rescale_to_total(served, total_height_m);
  } else if (sum_m <= 0 && total_height_m > 0) {
    served.warnings.push_back(formatted(
        "a total sea of Hs {:.3g} m has no usable partition: no waves can be made from it",
        total_height_m));
  }
  const double total_m = served.sea.significant_height_m();
  const double period_s = served.sea.peak_period_s();
  if (total_m > 0 && total_m > steepest_height_m(period_s) * rounding_allowance) {
    served.warnings.push_back(formatted(
        "the total sea, Hs {:.3g} m with Tp {:.3g} s, has a steepness of {:.3f}; the limit is "
        "{:.3f}: treat it with care",
        total_m, period_s, steepness_of(total_m, period_s),
        steepness_of(steepest_height_m(period_s), period_s)));
  }
  return served;
}

}  // namespace slackwater
