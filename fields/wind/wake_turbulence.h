#pragma once
#include <cmath>

#include "fields/base/constants.h"

namespace slackwater {

/// How the turbulence that a rotor adds is spread over its wake, r off the axis: 1 in the shear
/// behind the tips of the blades, r = D/2, less inside, and a Gaussian flank with the width of the
/// wake outside,
///
///   k1 exp(-(r - D/2)^2/(2 s^2)) + k2 exp(-(r + D/2)^2/(2 s^2)),
///   k1 = cos^2(pi/2 (r/D - 1/2)), k2 = cos^2(pi/2 (r/D + 1/2)) for r <= D/2, else 1 and 0.
///
/// On the axis exp(-D^2/(8 s^2)). Their correction for the ground, below the hub, is left out.
///
/// @param width_m  s > 0, the standard deviation of the wake's deficit
/// Source: Ishihara & Qian (2018), J. Wind Eng. Ind. Aerodyn. 177, 275, eqs. 21 to 23.
[[nodiscard]] inline double wake_turbulence_shape(double radius_m, double diameter_m,
                                                  double width_m) noexcept {
  const auto flank = [&](double off_m) {
    const double ratio = off_m / width_m;
    return std::exp(-0.5 * ratio * ratio);
  };
  const double share = radius_m / diameter_m;
  if (share > 0.5) return flank(radius_m - 0.5 * diameter_m);
  const auto part = [](double angle) { return std::cos(angle) * std::cos(angle); };
  const double quarter = 0.5 * constants::pi;
  return part(quarter * (share - 0.5)) * flank(radius_m - 0.5 * diameter_m) +
         part(quarter * (share + 0.5)) * flank(radius_m + 0.5 * diameter_m);
}

/// The most that a rotor adds anywhere, 0.362 (1 - sqrt(1 - Ct)): in the near wake, up to some
/// three diameters, where `added_turbulence` of the far wake would grow without bound.
/// Source: Crespo & Hernandez (1996), J. Wind Eng. Ind. Aerodyn. 61, 71.
[[nodiscard]] inline double near_wake_turbulence(double thrust_coefficient) noexcept {
  if (!(thrust_coefficient > 0)) return 0;
  return 0.362 * (1 - std::sqrt(1 - std::fmin(thrust_coefficient, 0.999)));
}

}  // namespace slackwater
