#include "fields/wind/kaimal_spectrum.h"

#include <array>
#include <cmath>

#include "fields/base/check.h"

namespace slackwater {
namespace {

constexpr std::array<double, 3> length_per_scale{8.1, 2.7, 0.66};
constexpr std::array<double, 3> sigma_ratio{1.0, 0.8, 0.5};

double of(const std::array<double, 3>& table, GustAxis axis) noexcept {
  return table[static_cast<std::size_t>(axis)];
}

}  // namespace

double reference_intensity(TurbulenceClass turbulence) noexcept {
  switch (turbulence) {
    case TurbulenceClass::a:
      return 0.16;
    case TurbulenceClass::b:
      return 0.14;
    case TurbulenceClass::c:
      break;
  }
  return 0.12;
}

double normal_turbulence_m_s(double hub_speed_m_s, double reference_intensity) noexcept {
  return reference_intensity * (0.75 * hub_speed_m_s + 5.6);
}

KaimalSpectrum::KaimalSpectrum(double mean_speed_m_s, double height_m, double sigma_along_m_s)
    : mean_speed_m_s_(mean_speed_m_s),
      scale_m_(height_m < 60.0 ? 0.7 * height_m : 42.0),
      sigma_m_s_(sigma_along_m_s) {
  expects(mean_speed_m_s > 0 && std::isfinite(mean_speed_m_s), "the mean wind must blow");
  expects(height_m > 0, "turbulence is asked for above the sea surface");
  expects(sigma_along_m_s >= 0 && std::isfinite(sigma_along_m_s), "sigma is 0 or more");
}

double KaimalSpectrum::sigma_m_s(GustAxis axis) const noexcept {
  return of(sigma_ratio, axis) * sigma_m_s_;
}

double KaimalSpectrum::length_m(GustAxis axis) const noexcept {
  return of(length_per_scale, axis) * scale_m_;
}

double KaimalSpectrum::density(GustAxis axis, double frequency_hz) const noexcept {
  const double sigma = sigma_m_s(axis);
  const double time_s = length_m(axis) / mean_speed_m_s_;
  return 4 * sigma * sigma * time_s / std::pow(1 + 6 * frequency_hz * time_s, 5.0 / 3.0);
}

double KaimalSpectrum::variance_below(GustAxis axis, double frequency_hz) const noexcept {
  const double sigma = sigma_m_s(axis);
  const double time_s = length_m(axis) / mean_speed_m_s_;
  return sigma * sigma * -std::expm1(-2.0 / 3.0 * std::log1p(6 * frequency_hz * time_s));
}

}  // namespace slackwater
