#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "twin/inspection/surface/surface_builder.h"

// Only sources of this folder include this.

namespace slackwater::twin {

struct PlanCircle {
  double north_m = 0;
  double east_m = 0;
  double radius_m = 0;
};

/// A piece of the bed or of the sea's surface, seen from above: squares of a map, cut at its edges.
struct PlanGrid {
  std::optional<PlanCircle> within;
  std::vector<Triple<double>> corners;  ///< of a convex polygon, clockwise; instead of `within`
  std::optional<PlanCircle> without;    ///< a foundation that stands there
  double finest_m = 0;                  ///< that the mesh has to show; 0: no finer than patches
  std::function<double(double north_m, double east_m)> z_m;
};

/// Outward is upward. The sheet is a map: east to the right, north at the top, true lengths of a
/// level piece.
/// @throws TooManyPatches
[[nodiscard]] Surface make_plan(SurfaceKind kind, const PlanGrid& grid, double patch_m);

}  // namespace slackwater::twin
