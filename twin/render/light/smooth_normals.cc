#include "twin/render/light/smooth_normals.h"

#include <numeric>
#include <span>

namespace slackwater::twin {
namespace {

constexpr double smooth_cosine = 0.8;
constexpr std::size_t smooth_as_they_are = 100000;

/// The triangles of each corner.
class FacesOfCorners {
 public:
  explicit FacesOfCorners(const TriangleMesh& mesh) : begin_(mesh.corners.size() + 1, 0) {
    for (const auto& triangle : mesh.triangles)
      for (const std::uint32_t corner : triangle) ++begin_[corner + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    faces_.resize(3 * mesh.triangles.size());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (const std::uint32_t corner : mesh.triangles[t]) faces_[next[corner]++] = t;
  }
  [[nodiscard]] std::span<const std::size_t> of(std::uint32_t corner) const {
    return std::span(faces_).subspan(begin_[corner], begin_[corner + 1] - begin_[corner]);
  }

 private:
  std::vector<std::size_t> begin_, faces_;
};

struct Face {
  Triple<double> area_m2;  ///< normal
  Triple<double> unit;     ///< zero of a face without an area
};
std::vector<Face> faces_of(const TriangleMesh& mesh) {
  std::vector<Face> faces;
  faces.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triple<double> area = mesh.area_vector_m2(t);
    const double length = length_of(area);
    faces.push_back({area, length > 0 ? (1 / length) * area : Triple<double>{}});
  }
  return faces;
}

}  // namespace

SmoothNormals::SmoothNormals(const TriangleMesh& mesh) : mesh_(mesh) {
  if (mesh.triangles.size() > smooth_as_they_are) return;
  const FacesOfCorners faces_at(mesh);
  const std::vector<Face> faces = faces_of(mesh);
  corners_.resize(faces.size());
  for (std::size_t t = 0; t < faces.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      Triple<double> sum;
      for (const std::size_t other : faces_at.of(mesh.triangles[t][k]))
        if (dot(faces[other].unit, faces[t].unit) >= smooth_cosine)
          sum = sum + faces[other].area_m2;
      const double length = length_of(sum);
      corners_[t][k] = length > 0 ? (1 / length) * sum : faces[t].unit;
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
  const auto& [at_a, at_b, at_c] = corners_[triangle];
  const Triple<double> mixed = (1 - weight_b - weight_c) * at_a + weight_b * at_b + weight_c * at_c;
  return (1 / length_of(mixed)) * mixed;
}

}  // namespace slackwater::twin
