#include "twin/render/light/smooth_normals.h"

namespace slackwater::twin {
namespace {

constexpr double smooth_cosine = 0.8;
constexpr std::size_t smooth_as_they_are = 100000;

}  // namespace

SmoothNormals::SmoothNormals(const TriangleMesh& mesh) : mesh_(mesh) {
  if (mesh.triangles.size() > smooth_as_they_are) return;
  corners_.resize(mesh.corners.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triple<double> area = mesh.area_vector_m2(t);
    for (const std::uint32_t corner : mesh.triangles[t]) corners_[corner] = corners_[corner] + area;
  }
}

Triple<double> SmoothNormals::at(std::size_t triangle, const Triple<double>& at_m,
                                 const Triple<double>& face) const noexcept {
  if (corners_.empty()) return face;
  const auto& [a, b, c] = mesh_.triangles[triangle];
  const Triple<double> from = mesh_.corner_m(a);
  const Triple<double> ab = mesh_.corner_m(b) - from, ac = mesh_.corner_m(c) - from;
  const Triple<double> n = cross(ab, ac), at = at_m - from;
  const double whole = dot(n, n);
  const double weight_b = dot(n, cross(at, ac)) / whole;
  const double weight_c = dot(n, cross(ab, at)) / whole;
  const auto unit_at = [&](std::uint32_t corner) {
    const double length = length_of(corners_[corner]);
    const Triple<double> one = length > 0 ? (1 / length) * corners_[corner] : face;
    return dot(one, face) > smooth_cosine ? one : face;
  };
  const Triple<double> mixed =
      (1 - weight_b - weight_c) * unit_at(a) + weight_b * unit_at(b) + weight_c * unit_at(c);
  return (1 / length_of(mixed)) * mixed;
}

}  // namespace slackwater::twin
