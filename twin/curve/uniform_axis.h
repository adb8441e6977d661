#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "fields/base/numbers/real.h"

namespace slackwater::twin {

/// Evenly spaced places, so that the place of a number among them is had without a search.
struct UniformAxis {
  double first = 0;
  double step = 1;
  std::size_t count = 2;  ///< at least 2

  [[nodiscard]] double at(std::size_t i) const { return first + step * static_cast<double>(i); }
};

/// Where a number stands on an axis: `below` counts steps from the first place to the one at or
/// below it.
template <typename Real>
struct PlaceOnAxis {
  Real below{};
  Real share{};  ///< of the step that follows, from 0 to 1
};

/// Beyond the ends, and for what is no number, the end: an index made from `below` is always good.
template <typename Real>
[[nodiscard]] PlaceOnAxis<Real> place_on(const UniformAxis& axis, const Real& x) {
  const double last = static_cast<double>(axis.count - 1);
  const Real steps = (x - axis.first) * (1 / axis.step);
  const Real held = smaller_of(larger_of(steps, Real{} + 0.0), Real{} + last);
  const Real below = smaller_of(whole_below(held), Real{} + (last - 1));
  return {below, held - below};
}

/// The straight line between two neighbours of a table.
template <typename Real>
struct OnLine {
  Real value{};
  Real rise{};  ///< from the one neighbour to the other
};
template <typename Real>
[[nodiscard]] OnLine<Real> on_line(const double* table, const PlaceOnAxis<Real>& place) {
  const Real low = entry_of(table, place.below);
  const Real rise = entry_of(table, Real{place.below + 1.0}) - low;
  return {low + place.share * rise, rise};
}

/// The coarsest uniform axis that holds all of the points, of which the first and last are its
/// ends, or nothing if it would need more than `most` places.
/// @param points rising, at least two
[[nodiscard]] std::optional<UniformAxis> uniform_axis_through(std::span<const double> points,
                                                              std::size_t most);

/// The broken line through (x, y) at the places of an axis; held beyond its ends. @param x rising
[[nodiscard]] std::vector<double> on_axis(const UniformAxis& axis, std::span<const double> x,
                                          std::span<const double> y);

}  // namespace slackwater::twin
