#include "fields/base/numbers/quantile.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"

namespace slackwater {

std::optional<double> quantile_of(std::vector<double> values, double share) {
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const double at = share * static_cast<double>(values.size() - 1);
  const auto low = static_cast<std::size_t>(at);
  const std::size_t high = std::min(low + 1, values.size() - 1);
  return values[low] + (at - static_cast<double>(low)) * (values[high] - values[low]);
}

double percentile(std::span<const double> ascending, std::size_t percent) {
  expects(!ascending.empty() && percent <= 100, "a percentile is that of one value at least");
  const PercentilePlace place = percentile_place(ascending.size(), percent);
  const double low = ascending[place.below];
  return place.hundredths == 0 ? low : place.between(low, ascending[place.below + 1]);
}

double nearest_quantile(std::span<const double> ascending, double share) {
  expects(!ascending.empty() && share >= 0 && share <= 1,
          "a quantile is that of one value at least");
  return ascending[static_cast<std::size_t>(
      std::lround(share * static_cast<double>(ascending.size() - 1)))];
}

}  // namespace slackwater
