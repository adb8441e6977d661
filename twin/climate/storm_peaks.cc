#include "twin/climate/storm_peaks.h"

#include <algorithm>
#include <cmath>

namespace slackwater::twin {

std::vector<StormPeak> storm_peaks(std::span<const double> values, double threshold,
                                   std::size_t separation_steps) {
  std::vector<StormPeak> peaks;
  std::size_t last = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(values[i] > threshold)) continue;
    if (peaks.empty() || i - last - 1 >= separation_steps)
      peaks.push_back({i, values[i]});
    else if (values[i] > peaks.back().value)
      peaks.back() = {i, values[i]};
    last = i;
  }
  return peaks;
}

std::vector<double> possible_thresholds(std::span<const double> values) {
  constexpr double most_share = 0.3;
  constexpr double least_share = 0.0003;
  constexpr int steps = 120;
  std::vector<double> ascending;
  ascending.reserve(values.size());
  std::copy_if(values.begin(), values.end(), std::back_inserter(ascending),
               [](double value) { return !std::isnan(value); });
  std::sort(ascending.begin(), ascending.end());
  std::vector<double> thresholds;
  for (int step = 0; step <= steps; ++step) {
    const double share = least_share * std::pow(most_share / least_share, 1.0 * step / steps);
    const auto above = static_cast<std::size_t>(share * static_cast<double>(ascending.size()));
    if (above == 0) continue;
    const double value = ascending[ascending.size() - above - 1];
    const auto next = std::upper_bound(ascending.begin(), ascending.end(), value);
    if (next == ascending.end()) continue;
    const double threshold = value + (*next - value) / 2;
    if (thresholds.empty() || threshold < thresholds.back()) thresholds.push_back(threshold);
  }
  return thresholds;
}

}  // namespace slackwater::twin
