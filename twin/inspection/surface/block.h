#pragma once
#include <array>
#include <functional>
#include <optional>

#include "twin/inspection/surface/surface_builder.h"

// Only sources of this folder include this.

namespace slackwater::twin {

/// Where the left upper corner of a face lies on the sheet.
struct FaceSheet {
  double left_m = 0;
  double top_m = 0;
};

/// A box, or what a box is bent to. Axes of its own: ahead, to the right, down, each from -1 to 1.
///
///   face        seen from outside: to the right      down
///   0 front     to the left (of the block)           down
///   1 back      to the right                         down
///   2 right     ahead                                down
///   3 left      to the back                          down
///   4 lower     to the left                          to the back
///   5 upper     to the right                         to the back
struct Block {
  Triple<double> size_m;                                                      ///< whole lengths
  std::function<Triple<double>(double ahead, double right, double down)> at;  ///< NED of the run
  std::array<std::optional<FaceSheet>, 6> faces;  ///< those that are patched
  double patch_m = 0;
};

/// The closed block. @throws TooManyPatches
void add_block(SurfaceBuilder& builder, const Block& block);

/// A plain box: middle, and unit vectors ahead and to the right, level or not.
[[nodiscard]] std::function<Triple<double>(double, double, double)> box_at(
    const Triple<double>& middle_m, const Triple<double>& ahead, const Triple<double>& right,
    const Triple<double>& size_m);

}  // namespace slackwater::twin
