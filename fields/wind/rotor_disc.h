#pragma once
#include <array>
#include <cmath>
#include <cstddef>

#include "fields/base/constants.h"

namespace slackwater {

/// A point of the unit disc: across to the left of the wind, up.
struct DiscPoint {
  double across;
  double up;
};

/// Points of the unit disc with the weights of a mean over it.
struct DiscRule {
  static constexpr std::size_t rings = 4;
  static constexpr std::size_t spokes = 8;
  std::array<DiscPoint, rings * spokes> points;
  std::array<double, rings * spokes> weights;  ///< add to 1
};

/// Rule for the mean over a disc: Gauss-Legendre of order 4 in the square of the radius, 8 equal
/// spokes, the first half a step from the horizontal. Exact for polynomials in the coordinates up
/// to degree 7; of a wake's edge across the disc it sees 32 samples.
[[nodiscard]] inline DiscRule disc_rule() noexcept {
  // Abramowitz & Stegun (1964), table 25.4, n = 4.
  constexpr std::array<double, 4> node{-0.861136311594053, -0.339981043584856, 0.339981043584856,
                                       0.861136311594053};
  constexpr std::array<double, 4> weight{0.347854845137454, 0.652145154862546, 0.652145154862546,
                                         0.347854845137454};
  DiscRule out{};
  for (std::size_t i = 0; i < DiscRule::rings; ++i) {
    const double radius = std::sqrt(0.5 * (1 + node[i]));
    for (std::size_t j = 0; j < DiscRule::spokes; ++j) {
      const double angle = 2 * constants::pi * (static_cast<double>(j) + 0.5) /
                           static_cast<double>(DiscRule::spokes);
      const std::size_t k = i * DiscRule::spokes + j;
      out.points[k] = {radius * std::cos(angle), radius * std::sin(angle)};
      out.weights[k] = 0.5 * weight[i] / static_cast<double>(DiscRule::spokes);
    }
  }
  return out;
}

}  // namespace slackwater
