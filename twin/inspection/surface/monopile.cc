#include "twin/inspection/surface/read_shape.h"
#include "twin/inspection/surface/shapes.h"

namespace slackwater::twin {

Surface make_monopile(const Config& config, double patch_m) {
  const Upright upright = read_upright(config);
  const double radius_m = config.number("radius_m", {0.05, 50});
  const Frustum pile{upright.north_m, upright.east_m, radius_m,
                     radius_m,        upright.top_m,  upright.bottom_m};
  const Arc arc = read_arc(config);
  SurfaceBuilder builder({upright.north_m, upright.east_m, upright.top_m});
  add_frustum(builder, pile, arc, patch_m);
  return builder.finish(SurfaceKind::monopile, sheet_of(pile, arc));
}

}  // namespace slackwater::twin
