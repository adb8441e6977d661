#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "fields/base/frame.h"
#include "fields/current/steady_response.h"

namespace slackwater {

/// The forward model of the current that calibration fits and service evaluates.
///
///   W(z, t) = W_interior A(z) + T(t) B(z)
///
/// The steady response to the wind stress T is linear, so A and B are computed once per parameter
/// set (`level_responses`). All vectors are east + i north, towards.

/// The name of a form in JSON and messages.
[[nodiscard]] std::string_view name_of(SteadyForm form) noexcept;

/// What a steady column depends on besides latitude, depth and wind.
struct SteadyParameters {
  double interior_east_m_s = 0;
  double interior_north_m_s = 0;
  double eddy_viscosity_m2_s = 0.03;  ///< nu > 0 (of the surface layer in three_layer)
  double bottom_friction_m_s = 5e-4;  ///< r > 0 of the linear bottom stress; finite_depth only
  double bottom_eddy_viscosity_m2_s = 5e-3;  ///< nu_b > 0 of the bed layer; three_layer only
  /// r_b > 0, drag on the base of the mixed layer; mixed_layer only. 1e-4 m/s over 25 m lets
  /// inertial motion decay in three days, within the 1 to 4 days of D'Asaro (1985), J. Phys.
  /// Oceanogr. 15, 1043.
  double base_friction_m_s = 1e-4;
  double mixed_layer_depth_m = 25.0;  ///< h > 0; mixed_layer only
  double stress_factor = 1.0;         ///< multiplies the wind stress; > 0

  [[nodiscard]] Horizontal interior_m_s() const noexcept {
    return {interior_east_m_s, interior_north_m_s};
  }
  bool operator==(const SteadyParameters&) const = default;
};

/// The shape that these parameters give a form.
[[nodiscard]] ColumnShape<double> shape_of(SteadyForm form,
                                           const SteadyParameters& parameters) noexcept;

/// The responses of a list of depths, structure of arrays, real and imaginary parts apart.
struct LevelResponses {
  std::vector<double> depth_m;
  std::vector<double> interior_re, interior_im;  ///< no dimension
  std::vector<double> stress_re, stress_im;      ///< m/s per Pa, the stress factor included

  [[nodiscard]] std::size_t levels() const noexcept { return depth_m.size(); }
  [[nodiscard]] Horizontal interior(std::size_t k) const {
    return {interior_re[k], interior_im[k]};
  }
  [[nodiscard]] Horizontal stress(std::size_t k) const { return {stress_re[k], stress_im[k]}; }
};

/// The form that holds in this water: finite_depth wherever the layers can meet, H < 2 (D_s + D_b),
/// with both Ekman depths those of `eddy_viscosity_m2_s`; three_layer in deeper water.
[[nodiscard]] SteadyForm default_form(
    double water_depth_m, Angle latitude,
    double eddy_viscosity_m2_s = SteadyParameters{}.eddy_viscosity_m2_s);

/// Computes A and B at the depths (m, positive down, >= 0; at and below the bed the value on the
/// bed). Equatorial band: A = 1, B = 0 (see `steady_responses`). About 0.2 us a level; allocates
/// the result.
[[nodiscard]] LevelResponses level_responses(SteadyForm form, const SteadyParameters& parameters,
                                             Angle latitude, double water_depth_m,
                                             std::span<const double> depths_m);

}  // namespace slackwater
