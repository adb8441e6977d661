#pragma once
#include <cmath>

/// How the mean wind grows with height over the sea: ratios of speeds, so that a vector keeps its
/// direction and a sampler multiplies once.
namespace slackwater {

/// Roughness of the open sea (IEC 61400-3; the value of fields/docs/physics.md, section 9).
inline constexpr double open_sea_roughness_m = 0.0002;

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

}  // namespace slackwater
