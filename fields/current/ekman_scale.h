#pragma once
#include <cmath>

#include "fields/base/constants.h"
#include "fields/current/complex.h"

namespace slackwater {

/// Length over which an Ekman spiral falls to 1/e and turns by one radian: l = sqrt(2 nu / |f|), m.
///
/// @param eddy_viscosity_m2_s  nu > 0
/// @param coriolis_rad_s       f, not 0
template <typename T>
[[nodiscard]] T ekman_scale_m(const T& eddy_viscosity_m2_s, double coriolis_rad_s) {
  using std::sqrt;
  return sqrt(T(2.0 / std::abs(coriolis_rad_s)) * eddy_viscosity_m2_s);
}

/// Ekman depth D = pi l, where the spiral points against its surface value, m.
template <typename T>
[[nodiscard]] T ekman_depth_m(const T& eddy_viscosity_m2_s, double coriolis_rad_s) {
  return T(constants::pi) * ekman_scale_m(eddy_viscosity_m2_s, coriolis_rad_s);
}

/// The eddy viscosity that has this Ekman depth: nu = |f| D^2 / (2 pi^2), m2/s.
[[nodiscard]] inline double eddy_viscosity_of_ekman_depth_m2_s(double depth_m,
                                                               double coriolis_rad_s) {
  const double scale_m = depth_m / constants::pi;
  return 0.5 * std::abs(coriolis_rad_s) * scale_m * scale_m;
}

/// lambda = (1 + i s)/l, s the sign of f: the root of lambda^2 = i f/nu whose real part is
/// positive, 1/m.
template <typename T>
[[nodiscard]] Complex<T> ekman_wavenumber(const T& eddy_viscosity_m2_s, double coriolis_rad_s) {
  const T inverse_scale = T(1.0) / ekman_scale_m(eddy_viscosity_m2_s, coriolis_rad_s);
  return {inverse_scale, coriolis_rad_s > 0 ? inverse_scale : -inverse_scale};
}

/// The current that one pascal of stress makes at the surface of deep water, 1/(rho nu lambda), m/s
/// per Pa: modulus 1/(rho sqrt(nu |f|)), turned 45 degrees to the right of the stress for f > 0.
template <typename T>
[[nodiscard]] Complex<T> surface_current_per_pascal(const T& eddy_viscosity_m2_s,
                                                    double coriolis_rad_s,
                                                    double water_density_kg_m3) {
  const Complex<T> wavenumber = ekman_wavenumber(eddy_viscosity_m2_s, coriolis_rad_s);
  return reciprocal(scaled(wavenumber, T(T(water_density_kg_m3) * eddy_viscosity_m2_s)));
}

}  // namespace slackwater
