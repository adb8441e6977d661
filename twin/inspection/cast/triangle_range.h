#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "twin/scene/structure.h"

namespace slackwater::twin {

/// The corners of a triangle, NED from the origin of its mesh.
using TriangleCorners = std::array<std::array<float, 3>, 3>;

/// The range at which a ray meets a triangle, from either side; nothing where it misses or runs
/// along the triangle's plane.
///
/// The ray passes within the edges where the volumes that it spans with them,
///
///   d . (a x b),  d . (b x c),  d . (c x a),      a, b, c counted from the ray's start,
///
/// have one sign; a volume of none, within what rounding makes of it, belongs to either. Two
/// triangles that share an edge have its volume alike to the last bit but for the sign (no fused
/// multiply-adds), so that no ray slips through between them. Then r = (n . a) / (n . d),
/// n = (b - a) x (c - a). Where a ray runs all but in the triangle's plane the volumes say nothing:
/// the place that it comes to has to lie in the triangle's box as well.
/// Sources: Platis and Theoharis (2003), Fast ray-tetrahedron intersection using Plucker
/// coordinates; Woop, Benthin and Wald (2013), Watertight ray/triangle intersection.
///
/// @param ray  NED from the origin of the mesh
[[nodiscard]] inline std::optional<double> range_within(const TriangleCorners& corners,
                                                        const Ray& ray) noexcept {
  const auto seen_from_start = [&](const std::array<float, 3>& at) -> Triple<double> {
    return {at[0] - ray.from_m.x, at[1] - ray.from_m.y, at[2] - ray.from_m.z};
  };
  const Triple<double> a = seen_from_start(corners[0]);
  const Triple<double> b = seen_from_start(corners[1]);
  const Triple<double> c = seen_from_start(corners[2]);
  const auto size = [](const Triple<double>& v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
  };
  const double a_m = size(a), b_m = size(b), c_m = size(c);
  // What rounding may make of a volume of none: at a corner, the signs of its edges would not go
  // together otherwise.
  const auto volume = [&](const Triple<double>& p, const Triple<double>& q, double sizes_m2) {
    const double v = dot(cross(p, q), ray.direction);
    return std::abs(v) <= 0x1p-50 * sizes_m2 ? 0.0 : v;
  };
  const double ab = volume(a, b, a_m * b_m);
  const double bc = volume(b, c, b_m * c_m);
  const double ca = volume(c, a, c_m * a_m);
  if (!((ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0))) return std::nullopt;
  const auto from_to = [&](std::size_t i, std::size_t k) -> Triple<double> {
    const auto &p = corners[i], &q = corners[k];
    return {double{q[0]} - p[0], double{q[1]} - p[1], double{q[2]} - p[2]};
  };
  const Triple<double> side = from_to(0, 1), other = from_to(0, 2);
  const Triple<double> normal = cross(side, other);
  const double towards = dot(normal, ray.direction);
  if (std::abs(towards) <= 0x1p-40 * size(side) * size(other)) return std::nullopt;
  const double range_m = dot(normal, a) / towards;
  if (!(range_m >= 0)) return std::nullopt;
  const double off_m = 0x1p-36 * (a_m + b_m + c_m);
  const auto is_within = [&](double at, double p, double q, double r) {
    return at >= std::min({p, q, r}) - off_m && at <= std::max({p, q, r}) + off_m;
  };
  const Triple<double> at = range_m * ray.direction;
  if (!is_within(at.x, a.x, b.x, c.x) || !is_within(at.y, a.y, b.y, c.y) ||
      !is_within(at.z, a.z, b.z, c.z))
    return std::nullopt;
  return range_m;
}

}  // namespace slackwater::twin
