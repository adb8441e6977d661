#pragma once
#include <string>
#include <vector>

#include "twin/inspection/surface/surface.h"

// Only sources of this folder include this.

namespace slackwater::twin {

/// More patches or triangles than a surface may have: said before room is made for them.
struct TooManyPatches {
  static constexpr std::size_t most_patches = 400000;
  static constexpr std::size_t most_triangles = 2000000;
};

/// Sizes that no surface can be made of.
struct Unmakeable {
  std::string key;  ///< of an entry of a scenario
  std::string why;
};

/// A surface while it is put together.
class SurfaceBuilder {
 public:
  /// @param origin_m  of the mesh: near it
  explicit SurfaceBuilder(const Triple<double>& origin_m);

  /// @throws TooManyPatches
  void expect_room(std::size_t patches, std::size_t triangles) const;

  /// @param at_m  NED of the run
  std::uint32_t add_corner(const Triple<double>& at_m);
  std::uint32_t add_patch(double along_m, double down_m, double width_m, double height_m);
  /// a, b, c as seen from outside: see TriangleMesh.
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                    std::uint32_t patch = no_patch);
  /// The patch's centre: by its weights of three corners of one of its triangles.
  void put_centre(std::uint32_t patch, const std::array<std::uint32_t, 3>& corners,
                  const std::array<double, 3>& weights);
  /// A fan that closes a ring of corners, which goes round as seen from outside.
  void add_cap(const std::vector<std::uint32_t>& ring);

  /// With the patches' areas and normals worked out.
  [[nodiscard]] Surface finish(SurfaceKind kind, Sheet sheet);

 private:
  Surface surface_;
};

/// As few pieces as are no longer than `piece_m`; rounding must not make one more of a length that
/// is a multiple of them.
[[nodiscard]] std::size_t pieces_in(double length_m, double piece_m);
/// The least odd number that is not less.
[[nodiscard]] std::size_t odd_from(double least);

}  // namespace slackwater::twin
