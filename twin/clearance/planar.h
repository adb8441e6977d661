#pragma once
#include <algorithm>
#include <cmath>

#include "twin/body/spatial.h"
#include "twin/control/reference.h"

namespace slackwater::twin {

/// A place or a way over the water, NED; depth and height are looked at apart.
struct Planar {
  double north = 0;
  double east = 0;

  friend Planar operator+(const Planar& a, const Planar& b) {
    return {a.north + b.north, a.east + b.east};
  }
  friend Planar operator-(const Planar& a, const Planar& b) {
    return {a.north - b.north, a.east - b.east};
  }
  friend Planar operator*(double s, const Planar& a) { return {s * a.north, s * a.east}; }
  friend bool operator==(const Planar&, const Planar&) = default;
};
[[nodiscard]] inline double dot(const Planar& a, const Planar& b) noexcept {
  return a.north * b.north + a.east * b.east;
}
[[nodiscard]] inline double size_of(const Planar& a) noexcept { return std::sqrt(dot(a, a)); }
/// Turned to the right by a right angle, seen from above.
[[nodiscard]] inline Planar to_the_right(const Planar& a) noexcept { return {-a.east, a.north}; }
[[nodiscard]] inline Planar planar(const Triple<double>& t) noexcept { return {t.x, t.y}; }
[[nodiscard]] inline Planar planar(const Course& c) noexcept { return {c.north, c.east}; }
/// Of length one; `otherwise` for what has no direction.
[[nodiscard]] inline Planar unit_of(const Planar& a, const Planar& otherwise) noexcept {
  const double size = size_of(a);
  return size > 1e-9 ? (1 / size) * a : otherwise;
}

/// The straight way between two places; a point where they are one.
struct Stretch {
  Planar from;
  Planar to;
};
[[nodiscard]] inline Planar nearest_on(const Stretch& s, const Planar& at) noexcept {
  const Planar along = s.to - s.from;
  const double square = dot(along, along);
  if (!(square > 0)) return s.from;
  return s.from + std::clamp(dot(at - s.from, along) / square, 0.0, 1.0) * along;
}

/// The two places of two stretches that are nearest to each other; the same one where they cross.
struct NearestPlaces {
  Planar on_a;
  Planar on_b;
};
[[nodiscard]] inline NearestPlaces nearest_places(const Stretch& a, const Stretch& b) noexcept {
  const Planar u = a.to - a.from, v = b.to - b.from, between = b.from - a.from;
  const double across = dot(to_the_right(u), v);
  if (across != 0) {
    const double on_a = dot(to_the_right(between), v) / across;
    const double on_b = dot(to_the_right(between), u) / across;
    if (on_a >= 0 && on_a <= 1 && on_b >= 0 && on_b <= 1)
      return {a.from + on_a * u, a.from + on_a * u};
  }
  // Else an end is the nearest of its stretch.
  NearestPlaces best{a.from, nearest_on(b, a.from)};
  const auto take = [&](const NearestPlaces& other) {
    if (size_of(other.on_a - other.on_b) < size_of(best.on_a - best.on_b)) best = other;
  };
  take({a.to, nearest_on(b, a.to)});
  take({nearest_on(a, b.from), b.from});
  take({nearest_on(a, b.to), b.to});
  return best;
}

}  // namespace slackwater::twin
