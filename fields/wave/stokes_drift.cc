#include "fields/wave/stokes_drift.h"

#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"

namespace slackwater {

using constants::pi;

double monochromatic_stokes_drift_m_s(double amplitude_m, double frequency_rad_s,
                                      double wavenumber_rad_m, double water_depth_m,
                                      double height_m) {
  expects(wavenumber_rad_m > 0 && water_depth_m > 0, "wavenumber and depth must be positive");
  expects(height_m <= 0 && height_m >= -water_depth_m, "the height lies between bed and surface");
  const double k = wavenumber_rad_m;
  // cosh 2k(z+h)/(2 sinh^2 kh) = [e^2kz + e^-2k(z+2h)]/(1 - e^-2kh)^2
  const double from_bed = -std::expm1(-2.0 * k * water_depth_m);
  const double shape =
      (std::exp(2.0 * k * height_m) + std::exp(-2.0 * k * (height_m + 2.0 * water_depth_m))) /
      (from_bed * from_bed);
  return amplitude_m * amplitude_m * frequency_rad_s * k * shape;
}

Horizontal stokes_drift_m_s(std::span<const WaveComponent> waves, const WaveWater& water,
                            double height_m) {
  Horizontal sum{};
  for (const WaveComponent& wave : waves) {
    const double k = std::abs(wave.wavenumber_rad_m);
    sum += monochromatic_stokes_drift_m_s(wave.amplitude_m, wave.intrinsic_rad_s, k, water.depth_m,
                                          height_m) *
           (wave.wavenumber_rad_m / k);
  }
  return sum;
}

double stokes_transport_m2_s(double significant_height_m, double tm01_s) {
  expects(significant_height_m >= 0 && tm01_s > 0, "a sea has a height and a period");
  return 2.0 * pi * significant_height_m * significant_height_m / (16.0 * tm01_s);
}

double stokes_share(double surface_m_s, double transport_m2_s, double height_m,
                    StokesProfile profile) {
  expects(surface_m_s >= 0 && transport_m2_s > 0, "a drift has a magnitude and a transport");
  expects(height_m <= 0, "the drift is asked for at or below the surface");
  if (surface_m_s == 0) return 0;
  if (profile == StokesProfile::exponential_integral_2014) {
    const double kz = surface_m_s / (5.97 * transport_m2_s) * height_m;
    return std::exp(2.0 * kz) / (1.0 - 8.0 * kz);
  }
  constexpr double beta = 1.0;
  const double k = surface_m_s * (1.0 - 2.0 * beta / 3.0) / (2.0 * transport_m2_s);
  const double root = std::sqrt(-2.0 * k * height_m);
  return std::exp(-root * root) - beta * std::sqrt(pi) * root * std::erfc(root);
}

Horizontal stokes_drift_m_s(Horizontal surface_m_s, double transport_m2_s, double height_m,
                            StokesProfile profile) {
  return surface_m_s * stokes_share(std::abs(surface_m_s), transport_m2_s, height_m, profile);
}

}  // namespace slackwater
