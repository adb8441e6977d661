#pragma once
#include "fields/current/finite_depth.h"

namespace slackwater {

/// The wind-driven current of stratified water: a mixed layer of depth h with the Ekman spiral
/// inside it, over an interior that the wind does not reach.
///
///   surface  ~~~~~~~~~~~~~   d <= h:  W = W_interior + T B_h(d)
///   base h   - - - - - - -   d >  h:  W = W_interior + T B_h(h) e^{-(d - h)/(h/4)}
///   interior                 A = 1
///
/// B_h is the stress response of `FiniteDepthColumn` over the depth h, its linear bottom stress now
/// the drag r_b between the layer and the water below: r_b -> 0 and large viscosity give the slab
/// of Pollard and Millard, h -> the water depth the finite column (without its friction on the
/// interior). Below the base the motion dies out over a quarter of the layer, the thickness of the
/// entrainment zone in large-eddy simulations and microstructure (0.1 to 0.3 h), so that levels
/// near the base see no jump.
///
/// Templated on the scalar: calibration differentiates the very lines that the service evaluates.
/// Source: Pollard and Millard (1970), Deep-Sea Res. 17, 813; Price, Weller and Pinkel (1986), J.
/// Geophys. Res. 91, 8411; the closed form of Welander (1957) inside the layer.
template <typename T>
class MixedLayerColumn {
 public:
  static constexpr double base_thickness_share = 0.25;

  /// @param eddy_viscosity_m2_s  nu > 0 inside the layer
  /// @param base_friction_m_s    r_b > 0
  /// @param mixed_layer_depth_m  h > 0
  MixedLayerColumn(const T& eddy_viscosity_m2_s, const T& base_friction_m_s,
                   const T& mixed_layer_depth_m, double coriolis_rad_s, double water_density_kg_m3)
      : depth_m_(mixed_layer_depth_m),
        layer_(FiniteDepthColumn<T>::linear_bottom_stress(eddy_viscosity_m2_s, base_friction_m_s,
                                                          coriolis_rad_s, water_density_kg_m3,
                                                          mixed_layer_depth_m)) {}

  /// The response at a depth (m, positive down, >= 0).
  [[nodiscard]] LevelResponse<T> at_depth(double depth_m) const {
    return {{T(1.0), T(0.0)},
            scaled(layer_.at_depth(depth_m).stress, base_taper(depth_m_, depth_m))};
  }

  /// 1 inside the layer, e^{-(d - h)/(h/4)} below it.
  [[nodiscard]] static T base_taper(const T& mixed_layer_depth_m, double depth_m) {
    using std::exp;
    if (!(mixed_layer_depth_m < T(depth_m))) return T(1.0);
    return exp((mixed_layer_depth_m - T(depth_m)) /
               (T(base_thickness_share) * mixed_layer_depth_m));
  }

 private:
  T depth_m_;
  FiniteDepthColumn<T> layer_;
};

}  // namespace slackwater
