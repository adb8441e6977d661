#pragma once
#include <array>
#include <vector>

#include "twin/inspection/surface/triangle_mesh.h"

namespace slackwater::twin {

/// Faces rounded off: the normal at a place of a face is the mean of those at its corners by the
/// place's weights, and that of a corner the mean, by their areas, of those of its faces that stand
/// at no more than 37 degrees to this one. So a box keeps its edges and its faces stay flat. Meshes
/// of more than 100 000 triangles are fine enough, and taken as they are.
class SmoothNormals {
 public:
  /// @param mesh  outlives it
  explicit SmoothNormals(const TriangleMesh& mesh);
  /// Unit, outward. @param face  unit, of the triangle
  [[nodiscard]] Triple<double> at(std::size_t triangle, const Triple<double>& at_m,
                                  const Triple<double>& face) const noexcept;

 private:
  const TriangleMesh& mesh_;
  std::vector<std::array<Triple<double>, 3>> corners_;  ///< unit, of each triangle
};

}  // namespace slackwater::twin
