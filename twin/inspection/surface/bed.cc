#include <algorithm>

#include "fields/base/text.h"
#include "twin/inspection/surface/plan_grid.h"
#include "twin/inspection/surface/scour_pit.h"
#include "twin/inspection/surface/shapes.h"
#include "twin/inspection/surface/usual_sizes.h"

namespace slackwater::twin {

Surface make(const BedSizes& sizes, double patch_m) {
  const Triple<double>& foot_m = sizes.foot_m;
  if (foot_m.z < 0) throw Unmakeable{"height_m", "puts the bed above the sea; give its depth_m"};
  ScourPit pit;
  pit.north_m = foot_m.x;
  pit.east_m = foot_m.y;
  pit.bed_m = foot_m.z;
  pit.pile_radius_m = sizes.radius_m;
  if (sizes.scour) pit = scour_pit(*sizes.scour, pit);
  const double outer_m = sizes.outer_m.value_or(usual::bed_radii * pit.pile_radius_m);
  if (!(outer_m > pit.pile_radius_m))
    throw Unmakeable{"outer_m", formatted("found {:g} m, within the foundation's {:g} m; give a "
                                          "radius beyond it",
                                          outer_m, pit.pile_radius_m)};
  if (pit.pile_radius_m + pit.width_m > outer_m && pit.depth_m > 0)
    throw Unmakeable{"outer_m", formatted("found {:g} m, and the scour pit reaches to {:.1f} m; "
                                          "give more",
                                          outer_m, pit.pile_radius_m + pit.width_m)};
  PlanGrid grid;
  grid.within = PlanCircle{foot_m.x, foot_m.y, outer_m};
  grid.without = PlanCircle{foot_m.x, foot_m.y, pit.pile_radius_m};
  // The pit's slope and the pile's curve, each in a few pieces.
  grid.finest_m = pit.pile_radius_m / 4;
  if (pit.depth_m > 0) grid.finest_m = std::min(grid.finest_m, pit.width_m / 4);
  grid.z_m = [&](double north_m, double east_m) { return pit.z_m(north_m, east_m); };
  Surface bed = make_plan(SurfaceKind::bed, grid, patch_m);
  bed.sheet.top_z_m = pit.bed_m;
  return bed;
}

}  // namespace slackwater::twin
