#include "fields/wave/dispersion.h"

#include <cmath>
#include <limits>

#include "fields/base/check.h"
#include "fields/base/constants.h"

namespace slackwater {
namespace {

using constants::gravity_m_s2;

constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
/// Newton doubles the digits each time; the slowest start below needs about thirty steps.
constexpr int most_iterations = 200;

/// k tanh(kh), and its derivative by k; sech underflows to 0 where tanh is 1.
double slope_of_k_tanh(double kh) {
  const double sech = 1.0 / std::cosh(kh);
  return std::tanh(kh) + kh * sech * sech;
}

void expect_water(double water_depth_m) {
  expects(water_depth_m > 0 && std::isfinite(water_depth_m), "the water depth must be positive");
}

}  // namespace

double wavenumber_rad_m(double frequency_rad_s, double water_depth_m) {
  expect_water(water_depth_m);
  expects(frequency_rad_s >= 0 && std::isfinite(frequency_rad_s),
          "a wave frequency must not be negative");
  if (frequency_rad_s == 0) return 0;
  const double deep = frequency_rad_s * frequency_rad_s * water_depth_m / gravity_m_s2;
  double kh = deep / std::sqrt(std::tanh(deep));
  for (int i = 0; i < most_iterations; ++i) {
    const double step = (kh * std::tanh(kh) - deep) / slope_of_k_tanh(kh);
    kh -= step;
    if (std::abs(step) <= rounding * kh) break;
  }
  return kh / water_depth_m;
}

double intrinsic_frequency_rad_s(double wavenumber_rad_m, double water_depth_m) {
  expect_water(water_depth_m);
  expects(wavenumber_rad_m >= 0, "a wavenumber must not be negative");
  return std::sqrt(gravity_m_s2 * wavenumber_rad_m * std::tanh(wavenumber_rad_m * water_depth_m));
}

double group_speed_m_s(double wavenumber_rad_m, double water_depth_m) {
  const double frequency = intrinsic_frequency_rad_s(wavenumber_rad_m, water_depth_m);
  if (frequency == 0) return std::sqrt(gravity_m_s2 * water_depth_m);
  return gravity_m_s2 * slope_of_k_tanh(wavenumber_rad_m * water_depth_m) / (2.0 * frequency);
}

std::optional<double> wavenumber_in_current_rad_m(double absolute_rad_s, double water_depth_m,
                                                  double current_along_wave_m_s) {
  expect_water(water_depth_m);
  expects(
      absolute_rad_s >= 0 && std::isfinite(absolute_rad_s) && std::isfinite(current_along_wave_m_s),
      "frequency and current must be finite, the frequency not negative");
  // omega(k) + k U is concave in k and starts at 0: Newton from below stays below the first root
  // and rises to it, or reaches the summit where there is none. The summit is where the wave stops.
  const double first_slope = std::sqrt(gravity_m_s2 * water_depth_m) + current_along_wave_m_s;
  if (first_slope <= 0) return std::nullopt;
  double k = absolute_rad_s / first_slope;
  for (int i = 0; i < most_iterations && k > 0; ++i) {
    const double slope = group_speed_m_s(k, water_depth_m) + current_along_wave_m_s;
    if (slope <= 0) return std::nullopt;
    const double step = (absolute_rad_s - k * current_along_wave_m_s -
                         intrinsic_frequency_rad_s(k, water_depth_m)) /
                        slope;
    k += step;
    if (step <= rounding * k) break;
  }
  return k;
}

}  // namespace slackwater
