#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "twin/inspection/surface/triangle_mesh.h"
#include "twin/scene/structure.h"

namespace slackwater::twin {

/// What a ray meets first.
struct CastHit {
  std::uint32_t mesh = 0;  ///< by its place among those that were given
  std::uint32_t triangle = 0;
  double range_m = 0;

  friend bool operator==(const CastHit&, const CastHit&) = default;
};

/// Rays at meshes, from either side of a triangle.
///
/// The answer is the least (range, mesh, triangle) of `range_to` over all triangles, to the bit.
/// Embree only says which triangles may be in a ray's way: their boxes are wider than all that
/// single precision can be wrong by, and each triangle in a box that is met is worked out by
/// `range_to`. So the answers do not hang on Embree's arithmetic: not on its instruction set, which
/// it is free to choose, nor on the reciprocals of one maker's processors.
///
/// Const calls from any threads; they do not allocate.
class RayCaster {
 public:
  /// @param meshes           corners finite, each triangle of three of them; copied
  /// @param device_settings  of Embree's device, for tests: "isa=sse2"
  /// @throws Error(internal) where Embree cannot be had, Error(unavailable) where memory ends
  explicit RayCaster(std::span<const TriangleMesh> meshes, const std::string& device_settings = {});
  ~RayCaster();
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;

  /// @param ray  NED of the run
  [[nodiscard]] std::optional<CastHit> first_hit(const Ray& ray, double most_range_m) const;
  /// Many in a row; the same answers.
  void first_hits(std::span<const Ray> rays, double most_range_m,
                  std::span<std::optional<CastHit>> hits) const;
  /// Whether it meets anything up to a range: faster than what it meets first.
  [[nodiscard]] bool is_blocked(const Ray& ray, double most_range_m) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

/// The range at which a ray meets a triangle, from either side (see triangle_range.h); nothing
/// where it misses.
/// @param ray  NED of the run
[[nodiscard]] std::optional<double> range_to(const TriangleMesh& mesh, std::size_t triangle,
                                             const Ray& ray) noexcept;

}  // namespace slackwater::twin
