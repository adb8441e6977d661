#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "twin/body/spatial.h"

namespace slackwater::twin {

/// Triangles about an origin of their own. Their corners are single-precision numbers, so that
/// whoever casts rays at them, and whoever works a hit out again, has the same triangles.
struct TriangleMesh {
  using Corner = std::array<float, 3>;  ///< NED from `origin_m`
  Triple<double> origin_m;              ///< NED of the run
  std::vector<Corner> corners;
  /// Three corners each, a, b, c: (b - a) x (c - a) points outward.
  std::vector<std::array<std::uint32_t, 3>> triangles;

  /// NED of the run.
  [[nodiscard]] Triple<double> corner_m(std::size_t corner) const noexcept;
  /// (b - a) x (c - a) / 2: as long as the triangle's area, m2.
  [[nodiscard]] Triple<double> area_vector_m2(std::size_t triangle) const noexcept;
  [[nodiscard]] Triple<double> centroid_m(std::size_t triangle) const noexcept;
};

[[nodiscard]] double area_m2(const TriangleMesh& mesh) noexcept;
/// What it encloses (divergence theorem); of one that is closed.
[[nodiscard]] double volume_m3(const TriangleMesh& mesh) noexcept;
/// Whether each edge belongs to two triangles, once in each direction.
[[nodiscard]] bool is_closed(const TriangleMesh& mesh);

}  // namespace slackwater::twin
