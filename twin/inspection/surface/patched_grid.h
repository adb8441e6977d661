#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "twin/inspection/surface/surface_builder.h"

// Only sources of this folder include this.

namespace slackwater::twin {

/// A patch on the sheet.
struct SheetCell {
  double along_m = 0;  ///< of its middle
  double down_m = 0;
  double width_m = 0;
  double height_m = 0;
};

/// Patches in columns and rows, each of them a grid of quadrilaterals of two triangles; odd
/// numbers, so that its middle is the middle of one of them.
struct PatchedGrid {
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::size_t across = 1;  ///< quadrilaterals a patch
  std::size_t high = 1;
  bool wraps = false;  ///< the last column's right edge is the first one's left edge
  /// To the right and then down is outward by the right hand: the sheet is seen from within, as
  /// where it goes clockwise round an upright axis; else it is seen from outside.
  bool is_from_within = true;
  /// A place of the surface by columns and rows, 0 to `columns`, 0 to `rows`: NED of the run.
  std::function<Triple<double>(double column, double row)> at;
  /// Nothing: those triangles only stand in the way.
  std::function<std::optional<SheetCell>(std::size_t column, std::size_t row)> sheet;
};

/// The corners of a grid that others join.
struct GridEdges {
  std::vector<std::uint32_t> top;     ///< from left to right
  std::vector<std::uint32_t> bottom;  ///< from left to right
};

/// @throws TooManyPatches
GridEdges add_grid(SurfaceBuilder& builder, const PatchedGrid& grid);
/// One that wraps both ways, like the surface of a ring: its last row's lower edge is its first
/// one's upper edge, and `at` is asked for neither twice.
/// @throws TooManyPatches
void add_closed_ring(SurfaceBuilder& builder, const PatchedGrid& grid);
/// Both ends of one that wraps.
void close_ends(SurfaceBuilder& builder, GridEdges edges);

}  // namespace slackwater::twin
