#include "fields/wave/spectrum.h"

#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"

namespace slackwater {
namespace {

using constants::pi;

constexpr double lowest_over_peak = 0.2;
constexpr double highest_over_peak = 60.0;
constexpr int simpson_cells = 2000;  ///< each side of the peak; even

/// Adds the moments between two frequencies, by Simpson's rule over ln omega: the spectrum spans
/// decades, and the kink of sigma at the peak is an end of the interval.
void add_moments(const JonswapSpectrum& spectrum, double from_rad_s, double to_rad_s,
                 SpectralMoments& sum) {
  const double step = std::log(to_rad_s / from_rad_s) / simpson_cells;
  for (int i = 0; i <= simpson_cells; ++i) {
    const double omega = from_rad_s * std::exp(step * i);
    const double rule = i == 0 || i == simpson_cells ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
    const double share = rule * step / 3.0 * spectrum.density(omega);  // omega^-1 of the n = 0 one
    sum.m_1 += share;
    sum.m0 += share * omega;
    sum.m1 += share * omega * omega;
    sum.m2 += share * omega * omega * omega;
  }
}

}  // namespace

double JonswapSpectrum::peak_rad_s() const noexcept { return 2.0 * pi / peak_period_s; }

double JonswapSpectrum::density(double frequency_rad_s) const noexcept {
  if (!(frequency_rad_s > 0)) return 0;
  const double peak = peak_rad_s();
  const double x = frequency_rad_s / peak;
  const double x4 = x * x * x * x;
  const double plain = 5.0 / 16.0 * significant_height_m * significant_height_m / (peak * x4 * x) *
                       std::exp(-1.25 / x4);
  if (gamma == 1.0) return normalisation * plain;
  const double off_peak = (x - 1.0) / (x < 1.0 ? 0.07 : 0.09);
  return normalisation * plain * std::pow(gamma, std::exp(-0.5 * off_peak * off_peak));
}

JonswapSpectrum jonswap_spectrum(double significant_height_m, double peak_period_s, double gamma) {
  expects(significant_height_m >= 0 && std::isfinite(significant_height_m),
          "the significant height must not be negative");
  expects(peak_period_s > 0 && std::isfinite(peak_period_s), "the peak period must be positive");
  expects(gamma >= 1 && gamma <= 10, "gamma must lie between 1 and 10");
  // The shape does not depend on height and period: one of m0 = 1/16 and omega_p = 1 tells A.
  const double unit_m0 = moments_of(JonswapSpectrum{1.0, 2.0 * pi, gamma, 1.0}).m0;
  return {significant_height_m, peak_period_s, gamma, 1.0 / (16.0 * unit_m0)};
}

double dnv_gamma(double significant_height_m, double peak_period_s) {
  expects(significant_height_m > 0 && peak_period_s > 0,
          "gamma needs a height and a period above 0");
  const double ratio = peak_period_s / std::sqrt(significant_height_m);
  if (ratio <= 3.6) return 5.0;
  if (ratio >= 5.0) return 1.0;
  return std::exp(5.75 - 1.15 * ratio);
}

double SpectralMoments::significant_height_m() const noexcept { return 4.0 * std::sqrt(m0); }
double SpectralMoments::tm02_s() const noexcept { return 2.0 * pi * std::sqrt(m0 / m2); }
double SpectralMoments::energy_period_s() const noexcept { return 2.0 * pi * m_1 / m0; }

SpectralMoments moments_of(const JonswapSpectrum& spectrum) {
  const double peak = spectrum.peak_rad_s();
  SpectralMoments sum;
  add_moments(spectrum, lowest_over_peak * peak, peak, sum);
  add_moments(spectrum, peak, highest_over_peak * peak, sum);
  return sum;
}

}  // namespace slackwater
