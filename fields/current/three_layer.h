#pragma once
#include <algorithm>

#include "fields/current/bottom_ekman_layer.h"
#include "fields/current/ekman_layer.h"
#include "fields/current/level_response.h"

namespace slackwater {

/// The steady current of deep water: surface Ekman spiral, geostrophic interior, bottom Ekman
/// spiral.
///
///   surface  ~~~~~~~~  W = W_g A(H - d) + T B(d)
///   interior           A = 1, B = 0, to 0.2 % beyond two Ekman depths of either boundary
///   bed      ////////
///
/// The two layers are added everywhere and never cut off, so no interface exists at which the
/// profile could jump. What is left of the wind spiral on the bed is below 0.2 % of its surface
/// speed where H >= 2 (D_s + D_b); shallower water wants `FiniteDepthColumn`.
///
/// Templated on the scalar: calibration differentiates the very lines that the service evaluates.
template <typename T>
class ThreeLayerColumn {
 public:
  /// @param eddy_viscosity_m2_s         nu of the surface layer, > 0
  /// @param bottom_eddy_viscosity_m2_s  nu of the bed layer, > 0
  /// @param coriolis_rad_s              f, not 0
  /// @param water_density_kg_m3         rho > 0
  /// @param water_depth_m               H > 0
  ThreeLayerColumn(const T& eddy_viscosity_m2_s, const T& bottom_eddy_viscosity_m2_s,
                   double coriolis_rad_s, double water_density_kg_m3, double water_depth_m)
      : water_depth_m_(water_depth_m),
        surface_wavenumber_(ekman_wavenumber(eddy_viscosity_m2_s, coriolis_rad_s)),
        bottom_wavenumber_(ekman_wavenumber(bottom_eddy_viscosity_m2_s, coriolis_rad_s)),
        surface_current_per_pascal_(
            surface_current_per_pascal(eddy_viscosity_m2_s, coriolis_rad_s, water_density_kg_m3)) {}

  /// The response at a depth (m, positive down, >= 0). At and below the bed: the value on the bed.
  [[nodiscard]] LevelResponse<T> at_depth(double depth_m) const {
    const double height_m = std::max(water_depth_m_ - depth_m, 0.0);
    return {-expm1(scaled(bottom_wavenumber_, T(-height_m))),
            exp(scaled(surface_wavenumber_, T(-std::min(depth_m, water_depth_m_)))) *
                surface_current_per_pascal_};
  }

 private:
  double water_depth_m_;
  Complex<T> surface_wavenumber_;
  Complex<T> bottom_wavenumber_;
  Complex<T> surface_current_per_pascal_;
};

}  // namespace slackwater
