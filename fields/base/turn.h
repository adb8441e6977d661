#pragma once
#include <cmath>

#include "fields/base/constants.h"

namespace slackwater {

// One angle has many numbers, a whole turn apart. Three ranges are in use, each with its rule.
// Longitudes have a fourth, [-180, 180): normalised_longitude_deg in fields/geo.

/// The number in [0, turn): what is there already keeps its bits.
[[nodiscard]] inline double positive_turn(double angle, double turn) noexcept {
  const double rest = std::fmod(angle, turn);
  const double positive = rest < 0 ? rest + turn : rest;
  return positive >= turn ? 0.0 : positive;  // a hair below nought, and rounding
}
/// As on a compass: degrees in [0, 360).
[[nodiscard]] inline double compass_deg(double angle_deg) noexcept {
  return positive_turn(angle_deg, 360.0);
}
/// rad in [0, 2 pi).
[[nodiscard]] inline double compass_rad(double angle_rad) noexcept {
  return positive_turn(angle_rad, 2 * constants::pi);
}

/// The short way round, with its sign: degrees in [-180, 180]. Exact: IEEE 754's remainder.
[[nodiscard]] inline double short_way_deg(double angle_deg) noexcept {
  return std::remainder(angle_deg, 360.0);
}
/// rad in [-pi, pi].
[[nodiscard]] inline double short_way_rad(double angle_rad) noexcept {
  return std::remainder(angle_rad, 2 * constants::pi);
}

/// rad in [-pi, pi), by counting the turns: an angle of many turns keeps some of their rounding.
/// The rule of the autopilots and instruments.
[[nodiscard]] inline double wrapped_rad(double angle_rad) noexcept {
  constexpr double turn = 2 * constants::pi;
  return angle_rad - turn * std::floor(angle_rad / turn + 0.5);
}

}  // namespace slackwater
