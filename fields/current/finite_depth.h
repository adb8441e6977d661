#pragma once
#include "fields/current/ekman_scale.h"
#include "fields/current/level_response.h"

namespace slackwater {

/// The exact steady current over a depth H with constant eddy viscosity, wind stress on top and
/// friction at the bed; for shelf water, where the surface and the bed layer overlap.
///
/// It solves nu W'' = i f (W - W_g), nu W' = T/rho at z = 0, and at z = -H either W = 0 (no slip)
/// or the linear bottom stress nu W' = r W. With d the depth, lambda^2 = i f/nu and sigma = nu
/// lambda/r (0 for no slip):
///
///   W   = W_g A + T B
///   A   = [(1 - e^{-lambda(H+d)}) (1 - e^{-lambda(H-d)}) + sigma (1 - e^{-2 lambda H})]/Q
///   B   = e^{-lambda d} [1 - e^{-2 lambda(H-d)} + sigma (1 + e^{-2 lambda(H-d)})]
///         / (rho nu lambda Q)
///   Q   = 1 + e^{-2 lambda H} + sigma (1 - e^{-2 lambda H})
///
/// This is the closed form in sinh and cosh, both sides multiplied by 2 e^{-lambda H}: no term
/// overflows however deep the water, and with expm1 none loses digits when lambda H is small. Deep
/// water (H -> infinity) gives the infinite spiral, r -> infinity gives no slip: see the tests.
///
/// Templated on the scalar: calibration differentiates the very lines that the service evaluates.
/// Source: Ekman (1905); Welander (1957), Tellus 9, 45-52, for the wind-driven shelf column.
template <typename T>
class FiniteDepthColumn {
 public:
  /// @param eddy_viscosity_m2_s  nu > 0
  /// @param coriolis_rad_s       f, not 0
  /// @param water_density_kg_m3  rho > 0
  /// @param water_depth_m        H > 0
  [[nodiscard]] static FiniteDepthColumn no_slip(const T& eddy_viscosity_m2_s,
                                                 double coriolis_rad_s, double water_density_kg_m3,
                                                 const T& water_depth_m) {
    return FiniteDepthColumn(eddy_viscosity_m2_s, Complex<T>{T(0.0), T(0.0)}, coriolis_rad_s,
                             water_density_kg_m3, water_depth_m);
  }

  /// @param bottom_friction_m_s  r > 0 of the linear bottom stress rho r W, about Cd times the
  /// speed at the bed
  [[nodiscard]] static FiniteDepthColumn linear_bottom_stress(const T& eddy_viscosity_m2_s,
                                                              const T& bottom_friction_m_s,
                                                              double coriolis_rad_s,
                                                              double water_density_kg_m3,
                                                              const T& water_depth_m) {
    const Complex<T> wavenumber = ekman_wavenumber(eddy_viscosity_m2_s, coriolis_rad_s);
    return FiniteDepthColumn(eddy_viscosity_m2_s,
                             scaled(wavenumber, T(eddy_viscosity_m2_s / bottom_friction_m_s)),
                             coriolis_rad_s, water_density_kg_m3, water_depth_m);
  }

  /// The response at a depth (m, positive down, >= 0). At and below the bed: the value on the bed.
  [[nodiscard]] LevelResponse<T> at_depth(double depth_m) const {
    const T d = water_depth_m_ < T(depth_m) ? water_depth_m_ : T(depth_m);
    const T height_m = water_depth_m_ - d;
    const Complex<T> above_twice = decay_m1(T(2.0) * height_m);
    const Complex<T> two{T(2.0), T(0.0)};
    return {
        interior_of(decay_m1(water_depth_m_ + d), decay_m1(height_m)),
        exp(scaled(wavenumber_, -d)) * (slip_ * (above_twice + two) - above_twice) * stress_scale_};
  }

  /// The interior part of it alone, at half the cost.
  [[nodiscard]] Complex<T> interior_at_depth(double depth_m) const {
    const T d = water_depth_m_ < T(depth_m) ? water_depth_m_ : T(depth_m);
    return interior_of(decay_m1(water_depth_m_ + d), decay_m1(water_depth_m_ - d));
  }

  /// The mean over the whole depth: transport divided by H. Cost of one level.
  [[nodiscard]] LevelResponse<T> depth_mean() const {
    // Momentum over the column: i f H (mean - W_g) = T/rho - (bottom stress)/rho, with i f = nu
    // lambda^2.
    const Complex<T> one{T(1.0), T(0.0)};
    const Complex<T> inverse_lambda_h = reciprocal(scaled(wavenumber_, water_depth_m_));
    const Complex<T> two_decay = scaled(exp(scaled(wavenumber_, -water_depth_m_)), T(2.0));
    return {one + decay_m1_twice_depth_ * inverse_denominator_ * inverse_lambda_h,
            current_per_pascal_ * inverse_lambda_h * (one - two_decay * inverse_denominator_)};
  }

 private:
  FiniteDepthColumn(const T& eddy_viscosity_m2_s, const Complex<T>& slip, double coriolis_rad_s,
                    double water_density_kg_m3, const T& water_depth_m)
      : water_depth_m_(water_depth_m),
        wavenumber_(ekman_wavenumber(eddy_viscosity_m2_s, coriolis_rad_s)),
        slip_(slip),
        current_per_pascal_(
            surface_current_per_pascal(eddy_viscosity_m2_s, coriolis_rad_s, water_density_kg_m3)),
        decay_m1_twice_depth_(decay_m1(T(2.0) * water_depth_m)) {
    const Complex<T> two{T(2.0), T(0.0)};
    inverse_denominator_ = reciprocal(two + decay_m1_twice_depth_ - slip_ * decay_m1_twice_depth_);
    stress_scale_ = current_per_pascal_ * inverse_denominator_;
  }

  /// A of e^{-lambda(H+d)} - 1 and e^{-lambda(H-d)} - 1.
  [[nodiscard]] Complex<T> interior_of(const Complex<T>& below, const Complex<T>& above) const {
    return (below * above - slip_ * decay_m1_twice_depth_) * inverse_denominator_;
  }

  /// e^{-lambda x} - 1
  [[nodiscard]] Complex<T> decay_m1(const T& distance_m) const {
    return expm1(scaled(wavenumber_, -distance_m));
  }

  T water_depth_m_;
  Complex<T> wavenumber_;            ///< lambda
  Complex<T> slip_;                  ///< sigma
  Complex<T> current_per_pascal_;    ///< 1/(rho nu lambda)
  Complex<T> decay_m1_twice_depth_;  ///< e^{-2 lambda H} - 1
  Complex<T> inverse_denominator_;   ///< 1/Q
  Complex<T> stress_scale_;          ///< 1/(rho nu lambda Q)
};

}  // namespace slackwater
