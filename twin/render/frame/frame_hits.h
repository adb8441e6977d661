#pragma once
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "twin/inspection/surface/triangle_mesh.h"
#include "twin/render/frame/pinhole.h"

namespace slackwater::twin {

/// What each pixel of a picture meets first, row by row.
struct FrameHits {
  static constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max();

  int wide = 0;
  int high = 0;
  std::vector<double> range_m;          ///< along the ray; infinite where it meets nothing
  std::vector<std::uint32_t> mesh;      ///< by its place among those that were given, or `nothing`
  std::vector<std::uint32_t> triangle;  ///< of that mesh

  [[nodiscard]] std::size_t pixels() const noexcept { return range_m.size(); }
  [[nodiscard]] bool is_hit(std::size_t pixel) const noexcept { return mesh[pixel] != nothing; }
  bool operator==(const FrameHits&) const = default;
};

/// What the middle of each pixel meets first: the least (range, mesh, triangle) of `range_to` over
/// all triangles, to the bit, as `RayCaster::first_hit` has it of the same rays.
///
/// A picture's rays start at one place and lie in rows, so that not the rays look for triangles but
/// the triangles for rays: each is projected, and met (`TriangleFromStart`, in double precision)
/// by the pixels of the rectangle about it alone. The rectangle holds every pixel that could meet
/// it: with V = |n . a| six volumes of what eye and triangle span, and R the way to its farthest
/// corner, a ray that `range_within` lets pass has weights of the corners of no less than
///
///   -e,  e = 2^-46 R^3 / V
///
/// (the slack of its volumes, 2^-50 of the sizes, and their rounding, over n . d = n . a / r).
/// Where e is over 2^-20 it is seen all but edge-on, and the rectangle is that about its box.
///
/// Rows are shared out among the threads; a pixel is written by one, and keeps the least (range,
/// mesh, triangle) in whatever order triangles come, those that face the camera first: the bits are
/// the same for any number of threads, and no instruction set is asked for. 1280 x 720 pixels and
/// 400 000 triangles: see tests/bench/render_bench.cc.
///
/// @param meshes        corners finite, as the caster's
/// @param hits          written over
void find_first_hits(const Pinhole& camera, std::span<const TriangleMesh* const> meshes,
                     double most_range_m, int threads, FrameHits& hits);

}  // namespace slackwater::twin
