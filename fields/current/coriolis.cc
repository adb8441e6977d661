#include "fields/current/coriolis.h"

#include <cmath>

namespace slackwater {

double coriolis_parameter_rad_s(Angle latitude) noexcept {
  return 2.0 * constants::earth_rotation_rad_s * std::sin(latitude.radians());
}

bool is_equatorial(Angle latitude) noexcept {
  return std::abs(latitude.degrees()) < equatorial_band_deg;
}

}  // namespace slackwater
