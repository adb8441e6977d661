#include "twin/inspection/surface/rotor_axes.h"

#include <cmath>

#include "fields/base/constants.h"

namespace slackwater::twin {

BladeAxes blade_axes(double faces_rad, double azimuth_rad) noexcept {
  // Axes of the rotor's plane: up, and to the right as seen from upwind.
  const Triple<double> right{std::sin(faces_rad), -std::cos(faces_rad), 0};
  const Triple<double> up{0, 0, -1};
  return {{std::cos(faces_rad), std::sin(faces_rad), 0},
          std::cos(azimuth_rad) * up + std::sin(azimuth_rad) * right,
          -std::sin(azimuth_rad) * up + std::cos(azimuth_rad) * right};
}

double blade_azimuth_rad(int blade, double first_azimuth_rad) noexcept {
  return first_azimuth_rad + 2 * constants::pi / 3 * (blade - 1);
}

}  // namespace slackwater::twin
