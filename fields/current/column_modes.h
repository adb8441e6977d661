#pragma once
#include <cmath>
#include <vector>

#include "fields/base/constants.h"
#include "fields/current/complex.h"

namespace slackwater {

/// One vertical mode of a layer with constant eddy viscosity and linear drag on its base.
template <typename T>
struct ColumnMode {
  T wavenumber_1_m;       ///< k_n
  Complex<T> decay_1_s;   ///< lambda_n = nu k_n^2 + i f
  Complex<T> per_pascal;  ///< 1/(rho N_n lambda_n), m/s per Pa where the mode's cosine is 1
};

/// Root x of x tan(x) = `biot` in [n pi, (n + 1/2) pi), n = 0 the gravest. biot > 0.
[[nodiscard]] double mode_root(int n, double biot) noexcept;

/// Modes that forget within this rate answer at once, as the steady form does: five minutes.
inline constexpr double instant_1_s = 12.0 / 3600.0;
inline constexpr int most_column_modes = 64;

/// The modes of nu W'' = W_t + i f W, nu W' = 0 at the surface, nu W' = r W at the base (d = h):
///
///   k_n h tan(k_n h) = r h/nu,   phi_n = cos(k_n d),   lambda_n = i f + nu k_n^2,
///   N_n = h/2 (1 + sin(2 k_n h)/(2 k_n h)),
///   sum_n phi_n(d)/(rho N_n lambda_n) = B(d), the steady answer
///
/// down to those that answer within five minutes. The root is found in double precision; one Newton
/// step in T gives it its exact derivative.
///
/// @param eddy_viscosity_m2_s  nu > 0
/// @param friction_m_s         r > 0
/// @param layer_depth_m        h > 0
/// @param value                the plain number in a T
template <typename T, typename Value>
[[nodiscard]] std::vector<ColumnMode<T>> column_modes(const T& eddy_viscosity_m2_s,
                                                      const T& friction_m_s, const T& layer_depth_m,
                                                      double coriolis_rad_s, Value value) {
  using std::sin;
  const T biot = friction_m_s * layer_depth_m / eddy_viscosity_m2_s;
  std::vector<ColumnMode<T>> modes;
  for (int n = 0; n < most_column_modes; ++n) {
    const double root = mode_root(n, value(biot));
    const double c = std::cos(root);
    const double s = std::sin(root);
    const double slope = s + root * c + value(biot) * s;
    const T x = T(root) + (biot * T(c) - T(root * s)) / T(slope);
    ColumnMode<T> mode;
    mode.wavenumber_1_m = x / layer_depth_m;
    mode.decay_1_s = {eddy_viscosity_m2_s * mode.wavenumber_1_m * mode.wavenumber_1_m,
                      T(coriolis_rad_s)};
    if (n > 0 && value(mode.decay_1_s.re) > instant_1_s) break;
    const T norm_m = T(0.5) * layer_depth_m * (T(1.0) + sin(T(2.0) * x) / (T(2.0) * x));
    mode.per_pascal =
        reciprocal(scaled(mode.decay_1_s, T(T(constants::sea_water_density_kg_m3) * norm_m)));
    modes.push_back(mode);
  }
  return modes;
}

}  // namespace slackwater
