#pragma once
#include <span>

#include "fields/base/check.h"
#include "fields/current/coriolis.h"
#include "fields/current/finite_depth.h"
#include "fields/current/three_layer.h"

namespace slackwater {

/// Which closed form of the steady current holds.
enum class SteadyForm {
  three_layer,   ///< deep water: the boundary layers do not meet
  finite_depth,  ///< any depth, linear bottom stress: exact for constant eddy viscosity
};

/// The responses of the steady current at some depths: the one line of physics that the calibration
/// differentiates (T a dual number) and the service evaluates (T = double, steady_column.h).
///
/// @param bottom  the bed's parameter: linear friction r (m/s) for finite_depth, eddy viscosity of
/// the bed
///                layer (m2/s) for three_layer; > 0
/// @param depths_m  positive down, >= 0; at and below the bed the value on the bed
/// @param out     one response per depth
/// In the equatorial band (coriolis.h) the wind-driven term and the bed layer are dropped: interior
/// 1, stress 0.
template <typename T>
void steady_responses(SteadyForm form, const T& eddy_viscosity_m2_s, const T& bottom,
                      Angle latitude, double water_depth_m, std::span<const double> depths_m,
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
        eddy_viscosity_m2_s, bottom, coriolis_rad_s, density_kg_m3, water_depth_m);
    fill([&](double depth_m) { return column.at_depth(depth_m); });
  } else {
    const ThreeLayerColumn<T> column(eddy_viscosity_m2_s, bottom, coriolis_rad_s, density_kg_m3,
                                     water_depth_m);
    fill([&](double depth_m) { return column.at_depth(depth_m); });
  }
}

}  // namespace slackwater
