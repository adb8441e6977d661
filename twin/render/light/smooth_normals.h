#pragma once
#include <vector>

#include "twin/inspection/surface/triangle_mesh.h"

namespace slackwater::twin {

/// Faces rounded off: the normal at a place of a face is the mean of those at its corners by the
/// place's weights, and that of a corner the mean of its faces by their areas. Meshes of more than
/// 100 000 triangles are fine enough, and taken as they are.
class SmoothNormals {
 public:
  /// @param mesh  outlives it
  explicit SmoothNormals(const TriangleMesh& mesh);
  /// Unit, outward. @param face  unit, of the triangle; kept at an edge of more than 37 degrees
  [[nodiscard]] Triple<double> at(std::size_t triangle, const Triple<double>& at_m,
                                  const Triple<double>& face) const noexcept;

 private:
  const TriangleMesh& mesh_;
  std::vector<Triple<double>> corners_;
};

}  // namespace slackwater::twin
