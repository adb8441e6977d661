#include "twin/scene/structure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace slackwater::twin {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The part of a ray between two parallel planes at -half and half, seen from `at` with the slope
/// `along`.
struct Passage {
  double in_m = -infinity;
  double out_m = infinity;
};
Passage between_planes(double at, double along, double half) {
  if (along == 0) return std::abs(at) <= half ? Passage{} : Passage{infinity, -infinity};
  const double a = (-half - at) / along;
  const double b = (half - at) / along;
  return {std::min(a, b), std::max(a, b)};
}

std::optional<Hit> hit_of(const Cylinder& c, const Ray& ray) {
  const double north = ray.from_m.x - c.north_m, east = ray.from_m.y - c.east_m;
  const Triple<double>& d = ray.direction;
  Passage mantle;
  const double across2 = d.x * d.x + d.y * d.y;
  const double beyond = north * north + east * east - c.radius_m * c.radius_m;
  if (across2 > 0) {
    const double towards = -(north * d.x + east * d.y);
    const double root2 = towards * towards - across2 * beyond;
    if (root2 < 0) return std::nullopt;
    const double root = std::sqrt(root2);
    mantle = {(towards - root) / across2, (towards + root) / across2};
  } else if (beyond > 0) {
    return std::nullopt;
  }
  const Passage ends = between_planes(ray.from_m.z - 0.5 * (c.top_m + c.bottom_m), d.z,
                                      0.5 * (c.bottom_m - c.top_m));
  const double in_m = std::max(mantle.in_m, ends.in_m);
  if (in_m > std::min(mantle.out_m, ends.out_m) || in_m < 0) return std::nullopt;
  if (ends.in_m > mantle.in_m) return Hit{in_m, {0, 0, d.z > 0 ? -1.0 : 1.0}};
  return Hit{in_m, {(north + in_m * d.x) / c.radius_m, (east + in_m * d.y) / c.radius_m, 0}};
}

std::optional<Hit> hit_of(const Box& b, const Ray& ray) {
  const double cosine = b.heading_cosine, sine = b.heading_sine;
  const Triple<double> from = ray.from_m - b.centre_m;
  const std::array<double, 3> at{cosine * from.x + sine * from.y, cosine * from.y - sine * from.x,
                                 from.z};
  const Triple<double>& d = ray.direction;
  const std::array<double, 3> along{cosine * d.x + sine * d.y, cosine * d.y - sine * d.x, d.z};
  const std::array<double, 3> half{b.half_size_m.x, b.half_size_m.y, b.half_size_m.z};
  Passage inside;
  std::size_t side = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Passage p = between_planes(at[i], along[i], half[i]);
    if (p.in_m > inside.in_m) side = i;
    inside = {std::max(inside.in_m, p.in_m), std::min(inside.out_m, p.out_m)};
  }
  if (inside.in_m > inside.out_m || inside.in_m < 0) return std::nullopt;
  const double sign = along[side] > 0 ? -1 : 1;
  const Triple<double> normal = side == 0   ? Triple<double>{sign * cosine, sign * sine, 0}
                                : side == 1 ? Triple<double>{-sign * sine, sign * cosine, 0}
                                            : Triple<double>{0, 0, sign};
  return Hit{inside.in_m, normal};
}

}  // namespace

Box box_of(const Triple<double>& centre_m, const Triple<double>& half_size_m,
           double heading_rad) noexcept {
  return {centre_m, half_size_m, std::cos(heading_rad), std::sin(heading_rad)};
}

double signed_distance_m(const Structure& structure, const Triple<double>& at_m) {
  return std::visit([&](const auto& s) { return signed_distance_m(s, at_m); }, structure);
}

double least_distance_m(const Structure& structure, const Triple<double>& from_m,
                        const Triple<double>& to_m) {
  // The signed distance to a convex body is convex along a line: golden sections find its only
  // valley.
  const Triple<double> way = to_m - from_m;
  const auto distance = [&](double share) {
    return signed_distance_m(structure, from_m + share * way);
  };
  constexpr double golden = 0.6180339887498949;
  double low = 0, high = 1;
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double at_a = distance(a), at_b = distance(b);
  for (int i = 0; i < 60; ++i) {
    if (at_a < at_b) {
      high = b;
      b = a;
      at_b = at_a;
      a = high - golden * (high - low);
      at_a = distance(a);
    } else {
      low = a;
      a = b;
      at_a = at_b;
      b = low + golden * (high - low);
      at_b = distance(b);
    }
  }
  return std::min({distance(0), distance(0.5 * (low + high)), distance(1)});
}

std::optional<Hit> first_hit(const Structure& structure, const Ray& ray) {
  return std::visit([&](const auto& s) { return hit_of(s, ray); }, structure);
}

std::optional<Hit> hit_of_level(double level_m, const Ray& ray) {
  const double range_m = (level_m - ray.from_m.z) / ray.direction.z;
  if (!(range_m >= 0) || std::isinf(range_m)) return std::nullopt;
  return Hit{range_m, {0, 0, ray.direction.z > 0 ? -1.0 : 1.0}};
}

std::optional<Hit> first_hit(const Scene& scene, const Ray& ray) {
  std::optional<Hit> first;
  const auto take = [&](const std::optional<Hit>& hit) {
    if (hit && (!first || hit->range_m < first->range_m)) first = hit;
  };
  for (const Structure& structure : scene.structures) take(first_hit(structure, ray));
  if (ray.direction.z > 0) take(hit_of_level(scene.bed_m, ray));
  if (ray.direction.z < 0) take(hit_of_level(scene.surface_m, ray));
  return first;
}

}  // namespace slackwater::twin
