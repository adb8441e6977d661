#pragma once
#include "twin/inspection/surface/planned_surface.h"

namespace slackwater::twin {

/// A surface cut into patches about `patch_m` on a side: as few as are no longer. Sizes that are
/// left out are those of usual_sizes.h.
///
/// A patch_m of its own goes before the argument. Solids are closed. At most 400 000 patches and
/// 2 000 000 triangles: an own patch_m that would make more is refused, the argument is taken as a
/// wish and made longer.
///
/// @throws Error(invalid_input) for sizes that no surface can be made of
[[nodiscard]] Surface make_surface(const PlannedSurface& planned, double patch_m);

}  // namespace slackwater::twin
