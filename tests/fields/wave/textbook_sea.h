#pragma once
#include <cmath>

#include "fields/base/constants.h"
#include "fields/wave/dispersion.h"
#include "fields/wave/sea_sampling.h"

namespace slackwater::tests {

/// The formulae of Airy waves as a textbook prints them, with the C library's functions, at a level
/// z that is already stretched. An independent implementation: the library sums exponentials.
inline WaveSample textbook_sea(const SeaRealisation& sea, const WavePlace& at, double z) {
  WaveSample sum;
  const double h = sea.water().depth_m;
  for (const WaveComponent& wave : sea.waves()) {
    const double k = std::abs(wave.wavenumber_rad_m);
    const double a = wave.amplitude_m;
    const double sigma = wave.intrinsic_rad_s;
    const double theta = wave.wavenumber_rad_m.real() * at.east_m +
                         wave.wavenumber_rad_m.imag() * at.north_m - wave.absolute_rad_s * at.t_s +
                         wave.phase_rad;
    const double level = std::cosh(k * (z + h)) / std::sinh(k * h);
    const double upright = std::sinh(k * (z + h)) / std::sinh(k * h);
    const double e = wave.wavenumber_rad_m.real() / k;
    const double n = wave.wavenumber_rad_m.imag() / k;
    sum.motion.elevation_m += a * std::cos(theta);
    sum.motion.velocity_m_s[0] += a * sigma * level * std::cos(theta) * e;
    sum.motion.velocity_m_s[1] += a * sigma * level * std::cos(theta) * n;
    sum.motion.velocity_m_s[2] += a * sigma * upright * std::sin(theta);
    sum.acceleration_m_s2[0] += a * sigma * sigma * level * std::sin(theta) * e;
    sum.acceleration_m_s2[1] += a * sigma * sigma * level * std::sin(theta) * n;
    sum.acceleration_m_s2[2] -= a * sigma * sigma * upright * std::cos(theta);
    sum.pressure_pa += constants::sea_water_density_kg_m3 * constants::gravity_m_s2 * a *
                       std::cosh(k * (z + h)) / std::cosh(k * h) * std::cos(theta);
  }
  return sum;
}

/// A wave of this amplitude, intrinsic period and direction of travel in such water.
inline WaveComponent one_wave(double amplitude_m, double period_s, const WaveWater& water,
                              Horizontal towards = {1, 0}, double phase_rad = 0) {
  WaveComponent wave;
  wave.amplitude_m = amplitude_m;
  wave.intrinsic_rad_s = 2 * constants::pi / period_s;
  wave.wavenumber_rad_m =
      wavenumber_rad_m(wave.intrinsic_rad_s, water.depth_m) * towards / std::abs(towards);
  wave.absolute_rad_s =
      wave.intrinsic_rad_s + (std::conj(wave.wavenumber_rad_m) * water.current_m_s).real();
  wave.phase_rad = phase_rad;
  return wave;
}

}  // namespace slackwater::tests
