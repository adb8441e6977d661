#pragma once
#include "fields/current/ekman_scale.h"

namespace slackwater {

/// Wind-driven surface Ekman layer: velocity relative to the flow below it, per unit of surface
/// stress.
///
///   B(d) = exp(-lambda d)/(rho nu lambda),  lambda = (1 + i s) sqrt(|f|/(2 nu))
///
/// which is the spiral V0 exp(-d/l) exp(i [theta - s (pi/4 + d/l)]), V0 = |tau|/(rho sqrt(nu |f|)),
/// for a stress of modulus |tau| towards theta (counted from east to north), s the sign of f.
/// Steady, horizontally uniform, constant eddy viscosity, water deeper than about 2 pi l.
///
/// @param eddy_viscosity_m2_s  nu > 0
/// @param coriolis_rad_s       f, not 0 (callers exclude the equatorial band, coriolis.h)
/// @param water_density_kg_m3  rho > 0
/// @param depth_m              d >= 0, positive down from the still-water level
/// @return m/s per Pa, east + i north; multiply by the stress (towards). No allocation,
/// thread-safe.
/// @note  Transport is |tau|/(rho |f|), 90 degrees right of the stress for f > 0: see the tests. A
/// published
///        form turns the two components by opposite signs of the wind's angle and public code
///        divides by the square root of the density; this one is derived from nu W'' = i f W.
/// Source: Ekman (1905); Stewart, Introduction to Physical Oceanography, ch. 9.
template <typename T>
[[nodiscard]] Complex<T> surface_ekman_response(const T& eddy_viscosity_m2_s, double coriolis_rad_s,
                                                double water_density_kg_m3, double depth_m) {
  const Complex<T> wavenumber = ekman_wavenumber(eddy_viscosity_m2_s, coriolis_rad_s);
  return exp(scaled(wavenumber, T(-depth_m))) *
         surface_current_per_pascal(eddy_viscosity_m2_s, coriolis_rad_s, water_density_kg_m3);
}

/// The same for a given stress (Pa, towards): velocity in m/s.
[[nodiscard]] inline Horizontal surface_ekman_velocity(Horizontal stress_pa,
                                                       double eddy_viscosity_m2_s,
                                                       double coriolis_rad_s,
                                                       double water_density_kg_m3, double depth_m) {
  return stress_pa * to_horizontal(surface_ekman_response(eddy_viscosity_m2_s, coriolis_rad_s,
                                                          water_density_kg_m3, depth_m));
}

}  // namespace slackwater
