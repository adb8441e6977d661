#pragma once
#include <limits>

/// Physical and mathematical constants, SI. One place, each with its source.
namespace slackwater::constants {

inline constexpr double pi = 3.141592653589793238462643383279502884;
/// Radians of a degree.
inline constexpr double degree = pi / 180;
/// No number: what is missing, where a status says so beside it.
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
/// Sidereal rotation rate of the Earth (IERS Conventions 2010, table 1.2).
inline constexpr double earth_rotation_rad_s = 7.292115e-5;
/// Standard gravity (CGPM 1901).
inline constexpr double gravity_m_s2 = 9.80665;
/// Sea water of 35 psu near 10 degrees C (UNESCO 1981 equation of state gives 1026.95 at 0 dbar).
inline constexpr double sea_water_density_kg_m3 = 1025.0;
/// ISO 2533 sea-level air.
inline constexpr double air_density_kg_m3 = 1.225;
/// Mean Earth radius (IUGG R1), for distances on a sphere where metres do not matter.
inline constexpr double earth_radius_m = 6371008.8;
/// 90 % quantile of the standard normal (Abramowitz & Stegun 1964, table 26.5): the 10 and 90 %
/// quantiles of a normal stand this many standard deviations from its median.
inline constexpr double normal_p90 = 1.2815515655446004;

}  // namespace slackwater::constants
