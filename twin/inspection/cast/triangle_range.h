#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "twin/scene/structure.h"

namespace slackwater::twin {

/// The corners of a triangle, NED from the origin of its mesh.
using TriangleCorners = std::array<std::array<float, 3>, 3>;

/// A triangle as it lies about the start of rays: all of `range_within` that is the same for each
/// ray from there, so that the many rays of a picture do it once. Its answers are those of
/// `range_within` to the bit, which is made of it.
class TriangleFromStart {
 public:
  /// @param from_m  where the rays start, from the origin of the mesh
  TriangleFromStart(const TriangleCorners& corners, const Triple<double>& from_m) noexcept {
    const auto seen_from_start = [&](const std::array<float, 3>& at) -> Triple<double> {
      return {at[0] - from_m.x, at[1] - from_m.y, at[2] - from_m.z};
    };
    a_ = seen_from_start(corners[0]);
    b_ = seen_from_start(corners[1]);
    c_ = seen_from_start(corners[2]);
    const double a_m = size(a_), b_m = size(b_), c_m = size(c_);
    ab_ = {cross(a_, b_), 0x1p-50 * (a_m * b_m)};
    bc_ = {cross(b_, c_), 0x1p-50 * (b_m * c_m)};
    ca_ = {cross(c_, a_), 0x1p-50 * (c_m * a_m)};
    off_m_ = 0x1p-36 * (a_m + b_m + c_m);
  }

  /// Whether the ray passes within the edges.
  [[nodiscard]] bool is_within_edges(const Triple<double>& direction) const noexcept {
    const double ab = ab_.volume(direction);
    const double bc = bc_.volume(direction);
    const double ca = ca_.volume(direction);
    return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
  }
  /// Works the triangle's plane out: before `range_along`.
  void lay_plane(const TriangleCorners& corners) noexcept {
    const auto from_to = [&](std::size_t i, std::size_t k) -> Triple<double> {
      const auto &p = corners[i], &q = corners[k];
      return {double{q[0]} - p[0], double{q[1]} - p[1], double{q[2]} - p[2]};
    };
    const Triple<double> side = from_to(0, 1), other = from_to(0, 2);
    normal_ = cross(side, other);
    flat_ = 0x1p-40 * size(side) * size(other);
    ahead_ = dot(normal_, a_);
  }
  /// The range of a ray that passes within the edges, up to a range; nothing where it runs along
  /// the plane, or comes to it behind its start, beyond the range or beside the triangle.
  [[nodiscard]] std::optional<double> range_along(const Triple<double>& direction,
                                                  double most_range_m) const noexcept {
    const double towards = dot(normal_, direction);
    if (std::abs(towards) <= flat_) return std::nullopt;
    const double range_m = ahead_ / towards;
    if (!(range_m >= 0 && range_m <= most_range_m)) return std::nullopt;
    const auto is_within = [&](double at, double p, double q, double r) {
      return at >= std::min({p, q, r}) - off_m_ && at <= std::max({p, q, r}) + off_m_;
    };
    const Triple<double> at = range_m * direction;
    if (!is_within(at.x, a_.x, b_.x, c_.x) || !is_within(at.y, a_.y, b_.y, c_.y) ||
        !is_within(at.z, a_.z, b_.z, c_.z))
      return std::nullopt;
    return range_m;
  }

  /// The corners from the start.
  [[nodiscard]] const Triple<double>& a() const noexcept { return a_; }
  [[nodiscard]] const Triple<double>& b() const noexcept { return b_; }
  [[nodiscard]] const Triple<double>& c() const noexcept { return c_; }
  /// a x b, b x c, c x a: square to the planes through the start and each edge.
  [[nodiscard]] const Triple<double>& across_ab() const noexcept { return ab_.across; }
  [[nodiscard]] const Triple<double>& across_bc() const noexcept { return bc_.across; }
  [[nodiscard]] const Triple<double>& across_ca() const noexcept { return ca_.across; }
  /// (b - a) x (c - a), and its product with a: six volumes of what start and triangle span.
  [[nodiscard]] const Triple<double>& normal() const noexcept { return normal_; }
  [[nodiscard]] double ahead() const noexcept { return ahead_; }

 private:
  struct Edge {
    Triple<double> across;
    double slack = 0;  ///< what rounding may make of a volume of none

    // At a corner, the signs of its edges would not go together otherwise.
    [[nodiscard]] double volume(const Triple<double>& direction) const noexcept {
      const double v = dot(across, direction);
      return std::abs(v) <= slack ? 0.0 : v;
    }
  };
  [[nodiscard]] static double size(const Triple<double>& v) noexcept {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
  }
  Triple<double> a_, b_, c_;
  Edge ab_, bc_, ca_;
  double off_m_ = 0;
  Triple<double> normal_;
  double flat_ = 0;
  double ahead_ = 0;
};

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
  TriangleFromStart triangle(corners, ray.from_m);
  if (!triangle.is_within_edges(ray.direction)) return std::nullopt;
  triangle.lay_plane(corners);
  return triangle.range_along(ray.direction, std::numeric_limits<double>::infinity());
}

}  // namespace slackwater::twin
