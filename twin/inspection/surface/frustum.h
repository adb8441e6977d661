#pragma once
#include "twin/inspection/surface/patched_grid.h"
#include "twin/inspection/surface/planned_surface.h"

// Only sources of this folder include this.

namespace slackwater::twin {

/// An upright cylinder or cone without its point. z downwards, NED of the run.
struct Frustum {
  double north_m = 0;
  double east_m = 0;
  double top_radius_m = 0;
  double bottom_radius_m = 0;
  double top_m = 0;  ///< z
  double bottom_m = 0;

  [[nodiscard]] double slant_m() const noexcept;
};

/// The closed frustum. Its mantle is patched within the arc; its sheet has true lengths round and
/// down: levels one below the other, narrower ones in the middle. The corners are on the circle, at
/// least 36 all round: the mesh is within 0.4 % of the radius.
/// @param left_m, top_m  where on the sheet it begins
void add_frustum(SurfaceBuilder& builder, const Frustum& frustum, const Arc& arc, double patch_m,
                 double left_m = 0, double top_m = 0);

/// Of `along` where it goes clockwise from a bearing, `down` where it goes downwards.
[[nodiscard]] Sheet sheet_of(const Frustum& frustum, const Arc& arc);

}  // namespace slackwater::twin
