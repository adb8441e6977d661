#include "fields/base/frame.h"

#include <cmath>

namespace slackwater {
namespace {

double compass_degrees(double east, double north) noexcept {
  const double degrees = Angle::from_radians(std::atan2(east, north)).degrees();
  const double wrapped = degrees < 0 ? degrees + 360.0 : degrees;
  return wrapped >= 360.0 ? 0.0 : wrapped;
}

}  // namespace

double to_direction_deg(Horizontal velocity) noexcept {
  return compass_degrees(velocity.real(), velocity.imag());
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
