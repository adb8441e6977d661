#include "fields/wind/wake.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"

namespace slackwater {

Wake make_wake(const WakeSettings& settings, double diameter_m, double hub_height_m,
               double thrust_coefficient, double turbulence_intensity) {
  expects(diameter_m > 0 && hub_height_m > 0, "a rotor has a diameter and a height");
  expects(turbulence_intensity >= 0 && turbulence_intensity <= 1,
          "turbulence intensity is a fraction from 0 to 1, not a percentage");
  expects(!std::isnan(thrust_coefficient), "the thrust coefficient is not a number");
  expects(settings.jensen_growth >= 0 && settings.gaussian_growth.value_or(0) >= 0 &&
              settings.blended_shape.value_or(BlendedWakeShape{}).growth >= 0,
          "wakes do not narrow: growth is 0 or more");
  if (thrust_coefficient <= 0) return NoWake{};
  const double ct = std::min(thrust_coefficient, 0.999);
  switch (settings.model) {
    case WakeModel::jensen:
      return JensenWake(diameter_m, ct, settings.jensen_growth);
    case WakeModel::gaussian:
      return GaussianWake(diameter_m, ct,
                          settings.gaussian_growth.value_or(wake_growth(turbulence_intensity)));
    case WakeModel::larsen:
      return LarsenWake(diameter_m, ct, turbulence_intensity, settings.larsen_radius, hub_height_m);
    case WakeModel::blended:
      break;
  }
  return BlendedWake(diameter_m, ct,
                     settings.blended_shape.value_or(blended_wake_shape(ct, turbulence_intensity)));
}

double wake_deficit(const Wake& wake, double downstream_m, double radius_m) noexcept {
  if (!(downstream_m > 0)) return 0;
  return std::visit([&](const auto& w) { return w.deficit(downstream_m, radius_m); }, wake);
}

double added_turbulence(double thrust_coefficient, double ambient_intensity,
                        double downstream_diameters) noexcept {
  if (!(thrust_coefficient > 0) || !(downstream_diameters > 0)) return 0;
  const double induction = 0.5 * (1 - std::sqrt(1 - std::min(thrust_coefficient, 0.999)));
  return 0.73 * std::pow(induction, 0.8325) * std::pow(ambient_intensity, 0.0325) *
         std::pow(downstream_diameters, -0.32);
}

}  // namespace slackwater
