#pragma once
#include <cmath>

#include "fields/current/finite_depth.h"

namespace slackwater {

/// How one rotary tidal current stands over depth, relative to its mean over the column: friction
/// on the bed slows and turns it, and the sense that turns with the Earth has the thicker layer.
///
///   W(d, t) = W_mean S(d) e^{i w t},   S = A(d)/mean of A,
///   A the interior response of the finite column with f + w in place of f
///
/// w > 0 counter-clockwise, w < 0 clockwise. Where f + w vanishes (the inertial frequency) the
/// layer has no finite scale and the profile becomes the parabola of non-rotating flow, which the
/// formula reaches smoothly; f + w is kept 1e-7 rad/s away from zero.
///
/// Source: Prandle (1982), Geophys. Astrophys. Fluid Dyn. 22, 27-49; Souza and Simpson (1996),
/// Continental Shelf Res. 16, 1039.
template <typename T>
class TidalShape {
 public:
  TidalShape(const T& eddy_viscosity_m2_s, const T& bottom_friction_m_s, double coriolis_rad_s,
             double speed_rad_s, double water_depth_m)
      : column_(FiniteDepthColumn<T>::linear_bottom_stress(
            eddy_viscosity_m2_s, bottom_friction_m_s, kept_from_zero(coriolis_rad_s + speed_rad_s),
            constants::sea_water_density_kg_m3, T(water_depth_m))),
        inverse_mean_(reciprocal(column_.depth_mean().interior)) {}

  [[nodiscard]] Complex<T> at_depth(double depth_m) const {
    return column_.interior_at_depth(depth_m) * inverse_mean_;
  }

 private:
  static double kept_from_zero(double x) { return std::abs(x) < 1e-7 ? std::copysign(1e-7, x) : x; }

  FiniteDepthColumn<T> column_;
  Complex<T> inverse_mean_;
};

}  // namespace slackwater
