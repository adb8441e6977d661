#include "twin/inspection/surface/read_shape.h"
#include "twin/inspection/surface/shapes.h"
#include "twin/inspection/surface/usual_sizes.h"

namespace slackwater::twin {

Surface make_tower(const Config& config, double patch_m) {
  const Upright upright = read_upright(config);
  const double foot_m = config.number("radius_m", {0.05, 50});
  const Frustum tower{upright.north_m,
                      upright.east_m,
                      number_or(config, "top_radius_m", usual::tower_top_share * foot_m),
                      foot_m,
                      upright.top_m,
                      upright.bottom_m};
  const Arc arc = read_arc(config);
  SurfaceBuilder builder({upright.north_m, upright.east_m, upright.top_m});
  add_frustum(builder, tower, arc, patch_m);
  return builder.finish(SurfaceKind::tower, sheet_of(tower, arc));
}

}  // namespace slackwater::twin
