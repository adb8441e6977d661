#include "twin/inspection/surface/frustum.h"
#include "twin/inspection/surface/shapes.h"
#include "twin/inspection/surface/usual_sizes.h"

namespace slackwater::twin {

Surface make(const TowerSizes& sizes, double patch_m) {
  const Upright& upright = sizes.upright;
  expect_goes_down(upright);
  const Frustum tower{upright.north_m,
                      upright.east_m,
                      sizes.top_radius_m.value_or(usual::tower_top_share * sizes.radius_m),
                      sizes.radius_m,
                      upright.top_m,
                      upright.bottom_m};
  SurfaceBuilder builder({upright.north_m, upright.east_m, upright.top_m});
  add_frustum(builder, tower, sizes.arc, patch_m);
  return builder.finish(SurfaceKind::tower, sheet_of(tower, sizes.arc));
}

}  // namespace slackwater::twin
