#include "twin/inspection/surface/triangle_mesh.h"

#include <algorithm>

namespace slackwater::twin {
namespace {

Triple<double> own_m(const TriangleMesh& mesh, std::size_t corner) noexcept {
  const TriangleMesh::Corner& c = mesh.corners[corner];
  return {static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])};
}

}  // namespace

Triple<double> TriangleMesh::corner_m(std::size_t corner) const noexcept {
  return origin_m + own_m(*this, corner);
}

Triple<double> TriangleMesh::area_vector_m2(std::size_t triangle) const noexcept {
  const auto& t = triangles[triangle];
  const Triple<double> a = own_m(*this, t[0]);
  return 0.5 * cross(own_m(*this, t[1]) - a, own_m(*this, t[2]) - a);
}

Triple<double> TriangleMesh::centroid_m(std::size_t triangle) const noexcept {
  const auto& t = triangles[triangle];
  return origin_m + (1.0 / 3) * (own_m(*this, t[0]) + own_m(*this, t[1]) + own_m(*this, t[2]));
}

double area_m2(const TriangleMesh& mesh) noexcept {
  double sum_m2 = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    sum_m2 += length_of(mesh.area_vector_m2(t));
  return sum_m2;
}

double volume_m3(const TriangleMesh& mesh) noexcept {
  // Of the tetrahedra to the mesh's own origin, which is near: little is lost to rounding.
  double sum_m3 = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    sum_m3 += dot(own_m(mesh, mesh.triangles[t][0]), mesh.area_vector_m2(t)) / 3;
  return sum_m3;
}

bool is_closed(const TriangleMesh& mesh) {
  // Lower corner, higher corner, and which way the triangle goes along the edge.
  std::vector<std::array<std::uint32_t, 3>> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = t[i], to = t[(i + 1) % 3];
      if (from == to) return false;
      edges.push_back({std::min(from, to), std::max(from, to), from < to ? 0U : 1U});
    }
  std::sort(edges.begin(), edges.end());
  if (edges.empty() || edges.size() % 2 != 0) return false;
  for (std::size_t i = 0; i < edges.size(); i += 2) {
    const auto &a = edges[i], &b = edges[i + 1];
    const bool is_pair = a[0] == b[0] && a[1] == b[1] && a[2] != b[2];
    const bool is_third = i > 0 && a[0] == edges[i - 1][0] && a[1] == edges[i - 1][1];
    if (!is_pair || is_third) return false;
  }
  return true;
}

}  // namespace slackwater::twin
