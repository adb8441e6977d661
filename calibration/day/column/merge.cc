#include "calibration/day/column/merge.h"

#include <algorithm>
#include <cmath>

namespace slackwater::calibration {
namespace {

constexpr double fading_h = 6.0;
/// No forecast is surer than what the product's numbers resolve.
constexpr double least_sigma_m_s = 0.002;

double precision_of(double sigma_m_s) {
  const double sigma = std::max(sigma_m_s, least_sigma_m_s);
  return 1.0 / (sigma * sigma);
}

}  // namespace

std::vector<double> presence_of(const BaselineForecast& made, const VectorColumn& cells) {
  std::vector<double> presence(made.value.size(), 0.0);
  for (std::size_t k = 0; k < cells.levels(); ++k) {
    std::vector<UtcTime> absent;
    for (std::size_t t = 0; t < cells.times(); ++t) {
      if (!made.has(cells.offset(t, k))) absent.push_back(cells.time[t].centre());
    }
    for (std::size_t t = 0; t < cells.times(); ++t) {
      if (!made.has(cells.offset(t, k))) continue;
      double nearest_h = fading_h;
      for (const UtcTime time : absent)
        nearest_h = std::min(nearest_h, std::abs(hours_between(time, cells.time[t].centre())));
      presence[cells.offset(t, k)] = nearest_h / fading_h;
    }
  }
  return presence;
}

MethodForecast merged_with(const MethodForecast& own, const ProviderForecast& provider,
                           const VectorColumn& cells) {
  MethodForecast merged{Method::merged, own.made, own.sigma_m_s};
  const std::vector<double> presence = presence_of(provider.corrected, cells);
  for (std::size_t o = 0; o < merged.made.value.size(); ++o) {
    if (presence[o] <= 0 || !own.made.has(o)) continue;
    const double ours = precision_of(own.sigma_m_s[o]);
    const double theirs = presence[o] * precision_of(provider.corrected_sigma_m_s[o]);
    merged.made.value[o] =
        (ours * own.made.value[o] + theirs * provider.corrected.value[o]) / (ours + theirs);
    merged.sigma_m_s[o] = 1.0 / std::sqrt(ours + theirs);
  }
  return merged;
}

}  // namespace slackwater::calibration
