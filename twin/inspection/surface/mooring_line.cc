#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/inspection/surface/shapes.h"
#include "twin/inspection/surface/tube.h"
#include "twin/inspection/surface/usual_sizes.h"

namespace slackwater::twin {

Surface make(const MooringLineSizes& sizes, double patch_m) {
  Tube line{sizes.fairlead_m, sizes.anchor_m, sizes.radius_m.value_or(usual::chain_radius_m)};
  const double whole_m = length_of(line.to_m - line.from_m);
  if (whole_m < patch_m)
    throw Unmakeable{
        "anchor", formatted("is {:g} m from the fairlead, less than a patch of {:g} m; correct it, "
                            "or take a smaller patch_m",
                            whole_m, patch_m)};
  const double share = sizes.share.value_or(1);
  line.to_m = line.from_m + share * (line.to_m - line.from_m);
  SurfaceBuilder builder(line.from_m);
  add_tube(builder, line, patch_m, TubeSheet{0, 0, true});
  Sheet sheet;
  sheet.width_m = share * whole_m;
  sheet.height_m = 2 * constants::pi * line.radius_m;
  sheet.along = "from the fairlead to the anchor";
  sheet.down = "round the line, from its upper side";
  return builder.finish(SurfaceKind::mooring_line, sheet);
}

}  // namespace slackwater::twin
