#include "fields/base/frame.h"

#include <cmath>

#include "fields/base/turn.h"

namespace slackwater {

double to_direction_deg(Horizontal velocity) noexcept {
  return compass_deg(Angle::from_radians(std::atan2(velocity.real(), velocity.imag())).degrees());
}

double from_direction_deg(Horizontal velocity) noexcept { return to_direction_deg(-velocity); }

Horizontal vector_to_direction(double magnitude, double to_direction_deg) noexcept {
  const double angle = Angle::from_degrees(to_direction_deg).radians();
  return {magnitude * std::sin(angle), magnitude * std::cos(angle)};
}

Horizontal vector_from_direction(double magnitude, double from_direction_deg) noexcept {
  return -vector_to_direction(magnitude, from_direction_deg);
}

}  // namespace slackwater
