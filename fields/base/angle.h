#pragma once
#include <compare>

#include "fields/base/constants.h"

namespace slackwater {

/// An angle: radians inside, named at every door, so that 47 degrees never passes for 47 radians.
class Angle {
 public:
  constexpr Angle() = default;
  [[nodiscard]] static constexpr Angle from_degrees(double degrees) noexcept {
    return Angle(degrees * (constants::pi / 180.0));
  }
  [[nodiscard]] static constexpr Angle from_radians(double radians) noexcept {
    return Angle(radians);
  }
  [[nodiscard]] constexpr double degrees() const noexcept {
    return radians_ * (180.0 / constants::pi);
  }
  [[nodiscard]] constexpr double radians() const noexcept { return radians_; }
  constexpr auto operator<=>(const Angle&) const = default;
  constexpr Angle operator-() const noexcept { return Angle(-radians_); }

 private:
  explicit constexpr Angle(double radians) noexcept : radians_(radians) {}
  double radians_ = 0.0;
};

}  // namespace slackwater
