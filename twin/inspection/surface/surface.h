#pragma once
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "twin/inspection/surface/triangle_mesh.h"

namespace slackwater::twin {

/// What is inspected.
enum class SurfaceKind {
  monopile,          ///< the wet pile
  transition_piece,  ///< with boat landing and flange
  tower,
  nacelle,
  blade,
  anodes,
  mooring_line,
  cable,  ///< on or in the bed
  bed,    ///< about a foundation, with its scour
  water,  ///< the sea's surface: where a watch is kept
};
/// monopile, transition_piece, ...
[[nodiscard]] const char* name_of(SurfaceKind kind) noexcept;

/// A piece of a surface, about as wide as it is high: what is seen or not.
struct Patch {
  Triple<double> centre_m;  ///< NED of the run, on the mesh: within one of its triangles
  Triple<double> normal;    ///< unit, outward
  double area_m2 = 0;       ///< of the mesh
  double along_m = 0;       ///< of its centre on the sheet
  double down_m = 0;
  float width_m = 0;  ///< on the sheet
  float height_m = 0;
};

/// The surface laid flat, for people: `along` to the right, `down` downwards. Parts that do not
/// hang together lie beside or below one another, with gaps.
struct Sheet {
  double width_m = 0;
  double height_m = 0;
  bool is_all_round = false;  ///< its left and right edges are one
  std::string along;          ///< what the axes are, in words: "clockwise from north"
  std::string down;
  double first_bearing_rad = 0;  ///< of `along` = 0, where it goes round an upright axis
  double top_z_m = 0;            ///< z of `down` = 0 where `down` is downwards
};

/// Of a triangle that only stands in the way: the end of a pile, the back of an anode.
inline constexpr std::uint32_t no_patch = std::numeric_limits<std::uint32_t>::max();

/// One surface of one run.
struct Surface {
  std::string name;  ///< "A01/monopile"
  SurfaceKind kind{};
  TriangleMesh mesh;
  std::vector<Patch> patches;
  std::vector<std::uint32_t> patch_of;  ///< of each triangle, or `no_patch`
  Sheet sheet;

  [[nodiscard]] double area_m2() const noexcept;  ///< of its patches
};

/// @throws Error(invalid_input) for a surface with a hole, or that is inside out, in words that say
///         which and what to mend
void expect_closed(const Surface& surface);

}  // namespace slackwater::twin
