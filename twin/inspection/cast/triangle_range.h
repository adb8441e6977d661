#pragma once
#include <array>
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
/// have one sign; a volume of none belongs to either. Two triangles that share an edge have its
/// volume alike to the last bit but for the sign (no fused multiply-adds), so that no ray slips
/// through between them. Then r = (n . a) / (n . d), n = (b - a) x (c - a).
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
  const double ab = dot(cross(a, b), ray.direction);
  const double bc = dot(cross(b, c), ray.direction);
  const double ca = dot(cross(c, a), ray.direction);
  if (!((ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0))) return std::nullopt;
  const Triple<double> normal = cross(b - a, c - a);
  const double towards = dot(normal, ray.direction);
  if (towards == 0) return std::nullopt;
  const double range_m = dot(normal, a) / towards;
  if (!(range_m >= 0)) return std::nullopt;
  return range_m;
}

}  // namespace slackwater::twin
