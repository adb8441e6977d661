#pragma once
#include "fields/current/ekman_scale.h"

namespace slackwater {

/// Bottom Ekman layer over a no-slip bed: the flow as a fraction of the interior flow above it.
///
///   A(h) = 1 - exp(-lambda h),  lambda = (1 + i s) sqrt(|f|/(2 nu_b))
///
/// Near the bed the flow turns 45 degrees to the left of the interior for f > 0, to the right for f
/// < 0. Steady, constant eddy viscosity, water deeper than about 2 pi l.
///
/// @param eddy_viscosity_m2_s  nu_b > 0, of the bed layer
/// @param coriolis_rad_s       f, not 0
/// @param height_above_bed_m   h >= 0, positive up
/// @return no dimension; multiply by the interior velocity (east + i north). No allocation,
/// thread-safe. Source: Ekman (1905); Cushman-Roisin and Beckers, Introduction to Geophysical Fluid
/// Dynamics, ch. 8.
template <typename T>
[[nodiscard]] Complex<T> bottom_ekman_response(const T& eddy_viscosity_m2_s, double coriolis_rad_s,
                                               double height_above_bed_m) {
  const Complex<T> wavenumber = ekman_wavenumber(eddy_viscosity_m2_s, coriolis_rad_s);
  return -expm1(scaled(wavenumber, T(-height_above_bed_m)));
}

/// The same for a given interior flow (m/s): velocity in m/s.
[[nodiscard]] inline Horizontal bottom_ekman_velocity(Horizontal interior_m_s,
                                                      double eddy_viscosity_m2_s,
                                                      double coriolis_rad_s,
                                                      double height_above_bed_m) {
  return interior_m_s * to_horizontal(bottom_ekman_response(eddy_viscosity_m2_s, coriolis_rad_s,
                                                            height_above_bed_m));
}

}  // namespace slackwater
