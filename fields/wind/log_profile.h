#pragma once
#include <cmath>

#include "fields/base/frame.h"

/// How the mean wind grows with height over the sea: ratios of speeds, so that a vector keeps its
/// direction and a sampler multiplies once.
namespace slackwater {

/// Roughness of the open sea (IEC 61400-3; the value of fields/docs/physics.md, section 9).
inline constexpr double open_sea_roughness_m = 0.0002;
/// Exponent of the normal wind profile offshore (IEC 61400-3).
inline constexpr double offshore_shear_exponent = 0.14;
inline constexpr double von_karman = 0.4;

/// Neutral logarithmic profile: U(z)/U(z_r) = ln(z/z0) / ln(z_r/z0).
///
/// Surface layer, neutral stratification, flat sea; trusted to about 100 m, as an estimate above.
///
/// @param height_m            z above the sea surface, positive up; at and below z0 the wind is 0
/// @param reference_height_m  z_r > z0, where the speed is known (10 m in products)
/// @param roughness_m         z0 > 0
/// @return no dimension. One or two logarithms, no allocation, thread-safe; NaN in, NaN out.
/// @note  The inverse is the same function with the heights exchanged: from hub height to 10 m.
/// Source: Stull (1988), Introduction to Boundary Layer Meteorology, eq. 9.7.5.
[[nodiscard]] inline double log_profile_ratio(double height_m, double reference_height_m,
                                              double roughness_m = open_sea_roughness_m) noexcept {
  if (height_m <= roughness_m) return 0;
  return std::log(height_m / roughness_m) / std::log(reference_height_m / roughness_m);
}

/// Power law: U(z)/U(z_r) = (z/z_r)^a. At and below the surface the wind is 0.
/// Source: IEC 61400-1, normal wind profile; a = 0.14 offshore (IEC 61400-3), 0.11 in extreme wind.
[[nodiscard]] inline double power_profile_ratio(
    double height_m, double reference_height_m,
    double shear_exponent = offshore_shear_exponent) noexcept {
  if (height_m <= 0) return 0;
  return std::pow(height_m / reference_height_m, shear_exponent);
}

/// The shear exponent through two speeds at two heights; all > 0, the heights different.
[[nodiscard]] inline double shear_exponent_between(double low_height_m, double low_speed_m_s,
                                                   double high_height_m,
                                                   double high_speed_m_s) noexcept {
  return std::log(high_speed_m_s / low_speed_m_s) / std::log(high_height_m / low_height_m);
}

/// The roughness of the logarithmic profile through two speeds at two heights, the higher one
/// faster; all > 0. Grows without bound as the speeds become equal: NaN if the higher is not
/// faster.
[[nodiscard]] inline double roughness_between(double low_height_m, double low_speed_m_s,
                                              double high_height_m,
                                              double high_speed_m_s) noexcept {
  if (!(high_speed_m_s > low_speed_m_s)) return std::nan("");
  return std::exp(
      (high_speed_m_s * std::log(low_height_m) - low_speed_m_s * std::log(high_height_m)) /
      (high_speed_m_s - low_speed_m_s));
}

/// Neutral drag coefficient of the wind at 10 m, Cd = [kappa/ln(10/z0)]^2: 1.3667e-3 over the open
/// sea.
[[nodiscard]] inline double neutral_drag_coefficient(double roughness_m) noexcept {
  const double ratio = von_karman / std::log(10.0 / roughness_m);
  return ratio * ratio;
}

/// A profile as a value: which law, and its one number. Made at the edge, sampled a million times.
struct WindProfile {
  enum class Law { logarithmic, power };
  Law law = Law::logarithmic;
  double parameter = open_sea_roughness_m;  ///< z0 in m, or the exponent

  [[nodiscard]] double ratio(double height_m, double reference_height_m) const noexcept {
    return law == Law::logarithmic ? log_profile_ratio(height_m, reference_height_m, parameter)
                                   : power_profile_ratio(height_m, reference_height_m, parameter);
  }
  /// The wind at a height (m/s, ENU, towards) from the wind at the reference height.
  [[nodiscard]] Horizontal at(Horizontal reference_wind_m_s, double height_m,
                              double reference_height_m = 10.0) const noexcept {
    return reference_wind_m_s * ratio(height_m, reference_height_m);
  }
};

}  // namespace slackwater
