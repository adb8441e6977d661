#pragma once
#include <span>
#include <vector>

#include "fields/base/frame.h"

namespace slackwater::calibration {

/// Slab of water under the wind, time in hours, as reference-slab has it.
struct Slab {
  double damping_per_h = 0;       ///< r
  double coriolis_rad_h = 0;      ///< f
  double density_kg_m3 = 1026.0;  ///< rho
  double depth_m = 25.0;          ///< h
};

/// Kinematic stress from a 10 m wind: 1.225 C_D |w| w, Pa, with C_D = (0.79 + 0.08 |w|) 1e-3
/// below 20.5 m/s and 2.43e-3 above.
[[nodiscard]] Horizontal reference_stress_pa(Horizontal wind_m_s) noexcept;

/// Response s' = -(r + i f) s + tau/(rho h), m/s, from rest, in hourly steps:
///
///   s[n+1] = e^{-(r + i f)} s[n] + (F[n] + F[n+1])/2,   F = 3600 s tau/(rho h)
///
/// The homogeneous part is exact and the forcing the mean of its ends: the rule with which the
/// published figures of the reference were made. A steady stress gives exactly lambda/(1 -
/// e^{-lambda}), lambda = r + i f in h^-1, times the solution of the differential equation (about
/// half an hour of inertial turning ahead).
///
/// @param stress_pa  one per hour, ENU
/// @return one per hour, the first 0
[[nodiscard]] std::vector<Horizontal> slab_response(std::span<const Horizontal> stress_pa,
                                                    const Slab& slab);

}  // namespace slackwater::calibration
