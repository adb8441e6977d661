#pragma once

namespace slackwater {

/// How the energy of waves spreads about their mean direction: the **half-angle** form of
/// Longuet-Higgins, Cartwright & Smith (1963),
///
///   D(theta) = [2^(2s-1)/pi] [Gamma(s+1)^2/Gamma(2s+1)] cos^(2s)(theta/2),   -pi <= theta <= pi
///
/// whose integral over all directions is 1. It is not the cos^n(theta) form of some programs; near
/// the mean the two agree for n = s/2. s >= 0; s = 0 is the same energy from everywhere.
///
/// @param from_mean_rad  theta, any angle
/// @return 1/rad
[[nodiscard]] double spreading_density(double s, double from_mean_rad);

/// Mean of cos(theta): s/(s+1), what a buoy measures as r1.
[[nodiscard]] double spreading_first_moment(double s);
/// Mean of cos(2 theta): s(s-1)/((s+1)(s+2)), a buoy's r2.
[[nodiscard]] double spreading_second_moment(double s);
/// Circular standard deviation sqrt(2(1 - r1)) = sqrt(2/(s+1)), rad (Kuik et al. 1988).
[[nodiscard]] double circular_spread_rad(double s);
/// The angle below which the share `probability` of the energy lies, in [-pi, pi], by a table of
/// 512 cells over eight standard deviations: good to 1e-3 of the spread, for drawing directions.
[[nodiscard]] double spreading_quantile_rad(double s, double probability);

}  // namespace slackwater
