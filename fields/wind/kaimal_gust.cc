#include "fields/wind/kaimal_gust.h"

#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/base/random.h"

namespace slackwater {
namespace {

constexpr std::array<GustAxis, 3> all_axes{GustAxis::along, GustAxis::across, GustAxis::up};

}  // namespace

KaimalGust::KaimalGust(const KaimalSpectrum& spectrum, std::uint64_t run_seed,
                       std::string_view stream_name, KaimalBands bands) {
  expects(bands.bands >= 2, "a gust needs two bands or more");
  expects(bands.lowest_hz > 0 && bands.highest_hz > bands.lowest_hz, "bands go from low to high");
  Rng rng(run_seed, stream_name);
  const double growth = std::pow(bands.highest_hz / bands.lowest_hz, 1.0 / (bands.bands - 1));
  for (const GustAxis axis : all_axes) {
    auto& components = axes_[static_cast<std::size_t>(axis)];
    components.reserve(static_cast<std::size_t>(bands.bands));
    double low_hz = 0;
    double high_hz = bands.lowest_hz;
    for (int j = 0; j < bands.bands; ++j) {
      const double variance =
          spectrum.variance_below(axis, high_hz) - spectrum.variance_below(axis, low_hz);
      const double frequency_hz = rng.uniform(low_hz, high_hz);
      const double phase_rad = rng.uniform(0, 2 * constants::pi);
      components.push_back({std::sqrt(2 * variance), 2 * constants::pi * frequency_hz, phase_rad});
      low_hz = high_hz;
      high_hz = j + 2 == bands.bands ? bands.highest_hz : high_hz * growth;
    }
  }
}

double KaimalGust::sum(GustAxis axis, double t_s) const noexcept {
  double total = 0;
  for (const Component& c : axes_[static_cast<std::size_t>(axis)]) {
    total += c.amplitude_m_s * std::cos(c.angular_frequency_rad_s * t_s + c.phase_rad);
  }
  return total;
}

Gust KaimalGust::at(double t_s) const noexcept {
  return {sum(GustAxis::along, t_s), sum(GustAxis::across, t_s), sum(GustAxis::up, t_s)};
}

double KaimalGust::variance_m2_s2(GustAxis axis) const noexcept {
  double total = 0;
  for (const Component& c : axes_[static_cast<std::size_t>(axis)]) {
    total += 0.5 * c.amplitude_m_s * c.amplitude_m_s;
  }
  return total;
}

}  // namespace slackwater
