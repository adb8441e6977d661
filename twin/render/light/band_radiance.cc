#include "twin/render/light/band_radiance.h"

#include <algorithm>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "twin/render/light/fading.h"

namespace slackwater::twin {
namespace {

constexpr double stefan_boltzmann = 5.670374419e-8;  // W/(m2 K4)
constexpr double second_constant_m_k = 1.438776877e-2;

/// Share of a black body's radiation at wavelengths up to one.
double share_up_to(double wavelength_m, double temperature_k) noexcept {
  const double x = second_constant_m_k / (wavelength_m * temperature_k);
  constexpr int most_terms = 4000;
  constexpr double pi = constants::pi, whole = 15 / (pi * pi * pi * pi);
  double sum = 0;
  for (int n = 1; n <= most_terms && n * x < 60; ++n) {
    const double per = 1.0 / n;
    sum += fading(n * x) * per * (x * x * x + per * (3 * x * x + per * (6 * x + per * 6)));
  }
  return whole * sum;
}

}  // namespace

double BandRadiance::exact(double from_m, double to_m, double temperature_k) noexcept {
  const double square = temperature_k * temperature_k;
  return stefan_boltzmann * square * square / constants::pi *
         (share_up_to(to_m, temperature_k) - share_up_to(from_m, temperature_k));
}

BandRadiance::BandRadiance(double from_m, double to_m) {
  expects(from_m >= 1e-6 && from_m < to_m, "a band from 1 um on");
  for (std::size_t i = 0; i <= steps; ++i)
    radiance_.push_back(exact(from_m, to_m, coldest_k + step_k * static_cast<double>(i)));
}

std::size_t BandRadiance::step_of(double temperature_k) const noexcept {
  const double place = (temperature_k - coldest_k) / step_k;
  return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(steps - 1)));
}

double BandRadiance::of(double temperature_k) const noexcept {
  const std::size_t i = step_of(temperature_k);
  const double share =
      std::clamp((temperature_k - coldest_k) / step_k - static_cast<double>(i), 0.0, 1.0);
  return radiance_[i] + share * (radiance_[i + 1] - radiance_[i]);
}

double BandRadiance::temperature_k(double radiance) const noexcept {
  const auto next = std::upper_bound(radiance_.begin() + 1, radiance_.end() - 1, radiance);
  const auto i = static_cast<std::size_t>(next - radiance_.begin()) - 1;
  const double share =
      std::clamp((radiance - radiance_[i]) / (radiance_[i + 1] - radiance_[i]), 0.0, 1.0);
  return coldest_k + step_k * (static_cast<double>(i) + share);
}

double BandRadiance::slope(double temperature_k) const noexcept {
  const std::size_t i = step_of(temperature_k);
  return (radiance_[i + 1] - radiance_[i]) / step_k;
}

}  // namespace slackwater::twin
