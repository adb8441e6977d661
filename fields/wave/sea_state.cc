#include "fields/wave/sea_state.h"

#include <cmath>

#include "fields/base/constants.h"

namespace slackwater {

JonswapSpectrum WavePartition::spectrum() const {
  const bool calm = significant_height_m <= 0;
  return jonswap_spectrum(
      significant_height_m, peak_period_s,
      gamma.value_or(calm ? 1.0 : dnv_gamma(significant_height_m, peak_period_s)));
}

double PartitionedSea::significant_height_m() const noexcept {
  double sum = 0;
  for (const WavePartition& p : partitions) sum += p.significant_height_m * p.significant_height_m;
  return std::sqrt(sum);
}

const WavePartition* PartitionedSea::highest_peak() const noexcept {
  const WavePartition* found = nullptr;
  double highest = 0;
  for (const WavePartition& p : partitions) {
    const double peak = p.significant_height_m * p.significant_height_m * p.peak_period_s;
    if (peak <= highest) continue;
    highest = peak;
    found = &p;
  }
  return found;
}

double PartitionedSea::peak_period_s() const noexcept {
  const WavePartition* peak = highest_peak();
  return peak == nullptr ? 0 : peak->peak_period_s;
}

double PartitionedSea::from_direction_deg() const noexcept {
  const WavePartition* peak = highest_peak();
  return peak == nullptr ? 0 : peak->from_direction_deg;
}

double steepness_of(double significant_height_m, double peak_period_s) noexcept {
  return 2.0 * constants::pi * significant_height_m /
         (constants::gravity_m_s2 * peak_period_s * peak_period_s);
}

}  // namespace slackwater
