#pragma once
#include "twin/body/attitude.h"

namespace slackwater::twin {

/// Of the slopes of waves too short for a mesh, in wind: 0.003 + 0.00512 W, W of 12.5 m height,
/// up to 14 m/s measured. Source: Cox and Munk (1954), J. Opt. Soc. Am. 44(11), 838-850, clean
/// sea, both directions together.
[[nodiscard]] double mean_square_slope(double wind_m_s) noexcept;

/// Share of light that a water's face mirrors, at an angle off its normal: Schlick's
/// 0.02 + 0.98 (1 - cos)^5.
[[nodiscard]] double mirrored_share(double cosine) noexcept;

/// The sun in a rough face of water: radiance, 1/sr, per irradiance square to the sun's beam,
///
///   L = F(omega) exp(-tan^2 beta / s2) / (pi s2) / (4 cos theta cos^4 beta)
///
/// with the facet that mirrors the sun to the eye: beta off the face's normal, omega off the sun;
/// theta between eye and normal, at most 87 degrees of it. Facets in each other's shadow and light
/// mirrored twice are left out.
/// Source: Cox and Munk (1954), as above.
/// @param to_eye, to_sun, normal  unit
/// @param slope  mean square, above 0
[[nodiscard]] double sun_glint_per_sr(const Triple<double>& to_eye, const Triple<double>& to_sun,
                                      const Triple<double>& normal, double slope) noexcept;

}  // namespace slackwater::twin
