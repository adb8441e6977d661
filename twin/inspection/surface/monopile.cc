#include "twin/inspection/surface/frustum.h"
#include "twin/inspection/surface/shapes.h"

namespace slackwater::twin {

Surface make(const MonopileSizes& sizes, double patch_m) {
  const Upright& upright = sizes.upright;
  expect_goes_down(upright);
  const Frustum pile{upright.north_m, upright.east_m, sizes.radius_m,
                     sizes.radius_m,  upright.top_m,  upright.bottom_m};
  SurfaceBuilder builder({upright.north_m, upright.east_m, upright.top_m});
  add_frustum(builder, pile, sizes.arc, patch_m);
  return builder.finish(SurfaceKind::monopile, sheet_of(pile, sizes.arc));
}

}  // namespace slackwater::twin
