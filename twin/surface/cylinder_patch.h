#pragma once
#include <cstddef>

#include "twin/scene/structure.h"

namespace slackwater::twin {

/// A part of a pile's face, cut open at one bearing and laid flat: `along` clockwise (as seen from
/// above) from `from_rad`, on the face, and `down` from its upper edge. Lengths and areas on the
/// face are true.
///
///     0 ───────────── along ───────────► arc R
///     │  0   1   2  …  columns - 1
///   down      a cell a row and column, all of one size
///     ▼
///
struct CylinderPatch {
  Cylinder pile;
  double from_rad = 0;  ///< bearing of its first edge from the axis, clockwise from north
  double arc_rad = 0;   ///< as far as it goes round, above 0; 2 pi: all round
  double top_m = 0;     ///< z of its upper edge
  double bottom_m = 0;  ///< of its lower one, more than `top_m`
  std::size_t columns = 0;
  std::size_t rows = 0;

  [[nodiscard]] double width_m() const noexcept { return arc_rad * pile.radius_m; }
  [[nodiscard]] double height_m() const noexcept { return bottom_m - top_m; }
  [[nodiscard]] double girth_m() const noexcept;  ///< once round the pile
  [[nodiscard]] double column_m() const noexcept;
  [[nodiscard]] double row_m() const noexcept;
  [[nodiscard]] double cell_m2() const noexcept { return column_m() * row_m(); }
  [[nodiscard]] std::size_t cells() const noexcept { return columns * rows; }
  [[nodiscard]] bool is_all_round() const noexcept;
};

/// The patch in as few cells as are no longer than `cell_m` along any side.
/// @throws ContractViolation for a patch without an extent
[[nodiscard]] CylinderPatch cut_open(const Cylinder& pile, double from_rad, double arc_rad,
                                     double top_m, double bottom_m, double cell_m);

/// The place of a face that is nearest to some place beside it.
struct FacePlace {
  double along_m = 0;  ///< from 0 to less than the pile's girth
  double down_m = 0;   ///< of the patch's upper edge; below 0: above it
  double off_m = 0;    ///< how far the place is from the face, in the plane; negative inside
};
[[nodiscard]] FacePlace face_place(const CylinderPatch& patch, const Triple<double>& at_m) noexcept;

}  // namespace slackwater::twin
