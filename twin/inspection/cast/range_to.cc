#include "twin/inspection/cast/ray_caster.h"
#include "twin/inspection/cast/triangle_range.h"

namespace slackwater::twin {

std::optional<double> range_to(const TriangleMesh& mesh, std::size_t triangle,
                               const Ray& ray) noexcept {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return range_within({mesh.corners[a], mesh.corners[b], mesh.corners[c]},
                      {ray.from_m - mesh.origin_m, ray.direction});
}

}  // namespace slackwater::twin
