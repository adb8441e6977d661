#pragma once
#include <vector>

namespace slackwater {

/// A measured wave spectrum with its direction at each frequency, as a pitch-roll buoy gives it.
/// All arrays have the length of `frequency_hz`.
struct DirectionalSpectrum {
  std::vector<double> frequency_hz;        ///< middle of each band, > 0, ascending
  std::vector<double> density_m2_hz;       ///< variance density, >= 0 (NDBC's c11)
  std::vector<double> from_direction_deg;  ///< mean, clockwise from true north (alpha1); NaN: none
  std::vector<double> first_moment;        ///< r1 in [0, 1); NaN where there is no direction

  [[nodiscard]] std::size_t bands() const noexcept { return frequency_hz.size(); }
  bool operator==(const DirectionalSpectrum&) const = default;
};

/// Width of each band, Hz: half-way to its neighbours, the outermost as wide outwards as inwards. A
/// lone band has no width to be known by, which is a contract violation.
[[nodiscard]] std::vector<double> band_widths_hz(const std::vector<double>& frequency_hz);

/// What a buoy reports of its spectrum.
struct SpectrumSummary {
  double significant_height_m = 0;  ///< 4 sqrt(sum S df)
  double peak_period_s = 0;         ///< 1/f of the band of highest density; 0 for a calm sea
  double mean_period_s = 0;         ///< sqrt(m0/m2), NDBC's APD; 0 for a calm sea
  double from_direction_deg = 0;    ///< alpha1 of the peak band, NDBC's MWD; NaN where not known
  double spread_deg = 0;            ///< circular, sqrt(2(1 - r1)) of the peak band; NaN likewise
};
/// Source: NDBC, "How are significant wave height, dominant period, average period, and wave
/// steepness calculated?"; direction of the peak: Technical Document 96-01.
[[nodiscard]] SpectrumSummary summary_of(const DirectionalSpectrum& spectrum);

}  // namespace slackwater
