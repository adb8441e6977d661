#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "twin/inspection/surface/triangle_mesh.h"
#include "twin/scene/structure.h"

namespace slackwater::twin {

/// What a ray meets first.
struct CastHit {
  std::uint32_t mesh = 0;  ///< by its place among those that were given
  std::uint32_t triangle = 0;
  double range_m = 0;
};

/// Rays at meshes, from either side of a triangle. Which triangle comes first is found by Embree,
/// on one instruction set whatever the machine has; how far it is we work out ourselves, in double
/// precision. So the same ray gives the same bits on any machine. Const calls from any threads.
class RayCaster {
 public:
  /// @throws Error(internal) where Embree cannot be had
  explicit RayCaster(std::span<const TriangleMesh> meshes);
  ~RayCaster();
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;

  /// @param ray  NED of the run
  [[nodiscard]] std::optional<CastHit> first_hit(const Ray& ray, double most_range_m) const;
  /// Many at once: what is faster; the same answers.
  void first_hits(std::span<const Ray> rays, double most_range_m,
                  std::span<std::optional<CastHit>> hits) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

/// The range at which a ray meets a triangle, from either side (Moller and Trumbore 1997); nothing
/// where it misses.
[[nodiscard]] std::optional<double> range_to(const TriangleMesh& mesh, std::size_t triangle,
                                             const Ray& ray) noexcept;

}  // namespace slackwater::twin
