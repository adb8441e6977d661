#pragma once
#include <cmath>

#include "fields/base/constants.h"
#include "twin/inspection/surface/triangle_mesh.h"

namespace slackwater::twin {

/// An upright cylinder without ends: 2 `round` `high` triangles, outward.
inline TriangleMesh cylinder_mesh(const Triple<double>& top_m, double radius_m, double height_m,
                                  std::uint32_t round, std::uint32_t high) {
  TriangleMesh mesh;
  mesh.origin_m = top_m;
  for (std::uint32_t j = 0; j <= high; ++j)
    for (std::uint32_t i = 0; i < round; ++i) {
      const double bearing = 2 * constants::pi * i / round;
      mesh.corners.push_back({static_cast<float>(radius_m * std::cos(bearing)),
                              static_cast<float>(radius_m * std::sin(bearing)),
                              static_cast<float>(height_m * j / high)});
    }
  for (std::uint32_t j = 0; j < high; ++j)
    for (std::uint32_t i = 0; i < round; ++i) {
      const std::uint32_t a = j * round + i, b = j * round + (i + 1) % round;
      const std::uint32_t c = a + round, d = b + round;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
  return mesh;
}

/// A level rectangle that faces up: `north` by `east` squares.
inline TriangleMesh level_mesh(const Triple<double>& corner_m, double square_m, std::uint32_t north,
                               std::uint32_t east) {
  TriangleMesh mesh;
  mesh.origin_m = corner_m;
  for (std::uint32_t i = 0; i <= north; ++i)
    for (std::uint32_t j = 0; j <= east; ++j)
      mesh.corners.push_back(
          {static_cast<float>(square_m * i), static_cast<float>(square_m * j), 0.0F});
  for (std::uint32_t i = 0; i < north; ++i)
    for (std::uint32_t j = 0; j < east; ++j) {
      const std::uint32_t a = i * (east + 1) + j, b = a + 1, c = a + east + 1, d = c + 1;
      mesh.triangles.push_back({a, d, c});
      mesh.triangles.push_back({a, b, d});
    }
  return mesh;
}

inline Triple<double> unit(const Triple<double>& v) { return (1 / length_of(v)) * v; }

}  // namespace slackwater::twin
