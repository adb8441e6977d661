#pragma once
#include "twin/inspection/surface/patched_grid.h"

// Only sources of this folder include this.

namespace slackwater::twin {

/// A straight round bar: a fender, a chain as its envelope, a cable. NED of the run.
struct Tube {
  Triple<double> from_m;
  Triple<double> to_m;
  double radius_m = 0;
};

/// Where a part begins on the sheet, and how it lies there.
struct TubeSheet {
  double left_m = 0;
  double top_m = 0;
  bool lies = false;  ///< its length to the right; else downwards
};

/// The closed tube, of eight corners round at least. Round it the sheet begins at its upper side.
/// @param sheet  nothing: it is not patched
void add_tube(SurfaceBuilder& builder, const Tube& tube, double patch_m,
              const std::optional<TubeSheet>& sheet);

}  // namespace slackwater::twin
