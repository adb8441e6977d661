#include "fields/wave/directional_spectrum.h"

#include <cmath>

#include "fields/base/angle.h"
#include "fields/base/check.h"

namespace slackwater {

std::vector<double> band_widths_hz(const std::vector<double>& frequency_hz) {
  const std::size_t bands = frequency_hz.size();
  expects(bands >= 2, "a spectrum has two bands or more");
  std::vector<double> widths(bands);
  for (std::size_t i = 0; i < bands; ++i) {
    const double below =
        i > 0 ? frequency_hz[i] - frequency_hz[i - 1] : frequency_hz[1] - frequency_hz[0];
    const double above = i + 1 < bands ? frequency_hz[i + 1] - frequency_hz[i] : below;
    expects(below > 0 && above > 0, "the frequencies of a spectrum ascend");
    widths[i] = 0.5 * (below + above);
  }
  return widths;
}

SpectrumSummary summary_of(const DirectionalSpectrum& spectrum) {
  const std::vector<double> widths = band_widths_hz(spectrum.frequency_hz);
  SpectrumSummary summary;
  double m0 = 0;
  double m2 = 0;
  std::size_t peak = 0;
  for (std::size_t i = 0; i < spectrum.bands(); ++i) {
    const double variance = spectrum.density_m2_hz[i] * widths[i];
    m0 += variance;
    m2 += variance * spectrum.frequency_hz[i] * spectrum.frequency_hz[i];
    if (spectrum.density_m2_hz[i] > spectrum.density_m2_hz[peak]) peak = i;
  }
  summary.significant_height_m = 4.0 * std::sqrt(m0);
  summary.from_direction_deg = spectrum.from_direction_deg[peak];
  summary.spread_deg =
      Angle::from_radians(std::sqrt(2.0 * (1.0 - spectrum.first_moment[peak]))).degrees();
  if (m0 > 0) {
    summary.peak_period_s = 1.0 / spectrum.frequency_hz[peak];
    summary.mean_period_s = std::sqrt(m0 / m2);
  }
  return summary;
}

}  // namespace slackwater
