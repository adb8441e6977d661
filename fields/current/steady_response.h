#pragma once
#include <span>

#include "fields/base/check.h"
#include "fields/current/coriolis.h"
#include "fields/current/finite_depth.h"
#include "fields/current/mixed_layer.h"
#include "fields/current/three_layer.h"

namespace slackwater {

/// Which closed form of the steady current holds.
enum class SteadyForm {
  three_layer,   ///< deep water: the boundary layers do not meet
  finite_depth,  ///< any depth, linear bottom stress: exact for constant eddy viscosity
  mixed_layer,   ///< stratified water: the spiral inside a mixed layer, drag on its base
};

/// What gives the responses of a form their shape over depth.
template <typename T>
struct ColumnShape {
  T eddy_viscosity_m2_s;  ///< nu > 0, of the layer under the wind
  /// > 0: linear friction r of the bed (m/s, finite_depth), eddy viscosity of the bed layer (m2/s,
  /// three_layer), or drag on the base of the mixed layer (m/s, mixed_layer).
  T bottom;
  T mixed_layer_depth_m;  ///< h > 0; mixed_layer alone
};

/// The responses of the steady current at some depths: the one line of physics that the calibration
/// differentiates (T a dual number) and the service evaluates (T = double, steady_column.h).
///
/// @param depths_m  positive down, >= 0; at and below the bed the value on the bed
/// @param out     one response per depth
/// In the equatorial band (coriolis.h) the wind-driven term and the bed layer are dropped: interior
/// 1, stress 0.
template <typename T>
void steady_responses(SteadyForm form, const ColumnShape<T>& shape, Angle latitude,
                      double water_depth_m, std::span<const double> depths_m,
                      std::span<LevelResponse<T>> out) {
  expects(depths_m.size() == out.size(), "one response per depth");
  const double coriolis_rad_s = coriolis_parameter_rad_s(latitude);
  constexpr double density_kg_m3 = constants::sea_water_density_kg_m3;
  const auto fill = [&](const auto& response_at) {
    for (std::size_t k = 0; k < depths_m.size(); ++k) out[k] = response_at(depths_m[k]);
  };
  if (is_equatorial(latitude)) {
    fill([](double) { return LevelResponse<T>{{T(1.0), T(0.0)}, {T(0.0), T(0.0)}}; });
  } else if (form == SteadyForm::finite_depth) {
    const auto column = FiniteDepthColumn<T>::linear_bottom_stress(
        shape.eddy_viscosity_m2_s, shape.bottom, coriolis_rad_s, density_kg_m3, T(water_depth_m));
    fill([&](double depth_m) { return column.at_depth(depth_m); });
  } else if (form == SteadyForm::mixed_layer) {
    const MixedLayerColumn<T> column(shape.eddy_viscosity_m2_s, shape.bottom,
                                     shape.mixed_layer_depth_m, coriolis_rad_s, density_kg_m3);
    fill([&](double depth_m) { return column.at_depth(depth_m); });
  } else {
    const ThreeLayerColumn<T> column(shape.eddy_viscosity_m2_s, shape.bottom, coriolis_rad_s,
                                     density_kg_m3, water_depth_m);
    fill([&](double depth_m) { return column.at_depth(depth_m); });
  }
}

}  // namespace slackwater
