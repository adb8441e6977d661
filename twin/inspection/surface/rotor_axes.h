#pragma once
#include "twin/body/spatial.h"

namespace slackwater::twin {

/// How a blade of a stopped rotor stands: unit vectors, NED. The rotor's plane is upright (no tilt,
/// no cone), and it turns clockwise as seen from upwind.
struct BladeAxes {
  Triple<double> upwind;
  Triple<double> along;   ///< from the hub to the tip
  Triple<double> across;  ///< in the rotor's plane, the way it turns: to the leading edge
};

/// @param faces_rad    bearing to which the rotor looks
/// @param azimuth_rad  of the blade: 0 up, clockwise as seen from upwind
[[nodiscard]] BladeAxes blade_axes(double faces_rad, double azimuth_rad) noexcept;

/// Azimuth of a blade, 1 to 3, where the first one's is known.
[[nodiscard]] double blade_azimuth_rad(int blade, double first_azimuth_rad) noexcept;

}  // namespace slackwater::twin
