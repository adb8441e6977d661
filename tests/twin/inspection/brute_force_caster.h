#pragma once
#include <optional>
#include <vector>

#include "twin/inspection/cast/ray_caster.h"

namespace slackwater::twin {

/// What a ray meets first, by definition: all triangles, one after the other.
inline std::optional<CastHit> by_brute_force(const std::vector<TriangleMesh>& meshes,
                                             const Ray& ray, double most_range_m) {
  std::optional<CastHit> best;
  for (std::uint32_t m = 0; m < meshes.size(); ++m)
    for (std::uint32_t t = 0; t < meshes[m].triangles.size(); ++t) {
      const auto range_m = range_to(meshes[m], t, ray);
      if (range_m && *range_m <= most_range_m && (!best || *range_m < best->range_m))
        best = CastHit{m, t, *range_m};
    }
  return best;
}

}  // namespace slackwater::twin
