#include "calibration/fuse/comparison.h"

#include <algorithm>
#include <optional>

namespace slackwater::calibration {
namespace {

/// Beyond the product's levels an observation counts for the outermost one within this distance.
constexpr double beyond_levels_m = 3.0;

std::optional<DepthPlace> place_of(const std::vector<double>& levels, double depth_m) {
  if (depth_m <= levels.front()) {
    if (levels.front() - depth_m > beyond_levels_m) return std::nullopt;
    return DepthPlace{0, 0, 0};
  }
  const std::size_t last = levels.size() - 1;
  if (depth_m >= levels.back()) {
    if (depth_m - levels.back() > beyond_levels_m) return std::nullopt;
    return DepthPlace{last, last, 0};
  }
  const auto above = std::upper_bound(levels.begin(), levels.end(), depth_m);
  const auto high = static_cast<std::size_t>(above - levels.begin());
  return DepthPlace{high - 1, high,
                    (depth_m - levels[high - 1]) / (levels[high] - levels[high - 1])};
}

}  // namespace

Comparison::Comparison(const VectorColumn& product, const VectorColumn& observed,
                       const FusionSettings& settings)
    : product_(product) {
  for (std::size_t k = 0; k < observed.levels(); ++k) {
    const auto place = place_of(product.levels_m, observed.levels_m[k]);
    if (!place) continue;
    index_.push_back(k);
    place_.push_back(*place);
    level_.emplace_back(observed, k, settings);
  }
}

Differences Comparison::at(std::size_t t) const {
  Differences found;
  for (std::size_t m = 0; m < level_.size(); ++m) {
    const DepthPlace& place = place_[m];
    if (!product_.has(t, place.low) || !product_.has(t, place.high)) continue;
    const auto seen = level_[m].at(product_.time[t]);
    if (!seen) continue;
    const Horizontal there = (1 - place.share) * product_.value[product_.offset(t, place.low)] +
                             place.share * product_.value[product_.offset(t, place.high)];
    found.level.push_back(index_[m]);
    found.place.push_back(place);
    found.value.push_back(*seen - there);
    found.observed.push_back(*seen);
    found.noise_left.push_back(level_[m].noise_left(product_.time[t]));
  }
  return found;
}

}  // namespace slackwater::calibration
