#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/inspection/surface/plan_grid.h"
#include "twin/inspection/surface/shapes.h"

namespace slackwater::twin {
namespace {

/// Clockwise; refused where they are not round a convex piece.
std::vector<Triple<double>> clockwise(std::vector<Triple<double>> corners) {
  const std::size_t n = corners.size();
  if (n < 3) throw Unmakeable{"corners", formatted("found {}, expected at least three", n)};
  double turned_rad = 0;
  bool turns_right = false, turns_left = false;
  for (std::size_t i = 0; i < n; ++i) {
    const Triple<double> in = corners[(i + 1) % n] - corners[i];
    const Triple<double> out = corners[(i + 2) % n] - corners[(i + 1) % n];
    const double turn_rad = std::atan2(in.x * out.y - in.y * out.x, in.x * out.x + in.y * out.y);
    turned_rad += turn_rad;
    turns_right |= turn_rad > 1e-9;
    turns_left |= turn_rad < -1e-9;
  }
  // Once round, all one way.
  if (turns_right == turns_left || std::abs(std::abs(turned_rad) - 2 * constants::pi) > 1e-6)
    throw Unmakeable{"corners",
                     "go round a piece that is not convex; cut it into several surfaces"};
  if (turns_left) std::reverse(corners.begin(), corners.end());
  return corners;
}

}  // namespace

Surface make(const WaterSizes& sizes, double patch_m) {
  PlanGrid grid;
  if (const auto& disc = sizes.disc) {
    grid.within = PlanCircle{disc->north_m, disc->east_m, disc->radius_m};
    if (disc->inner_m.value_or(0) > 0)
      grid.without = PlanCircle{disc->north_m, disc->east_m, *disc->inner_m};
    if (grid.without && grid.without->radius_m >= grid.within->radius_m)
      throw Unmakeable{"inner_m", formatted("found {:g} m, expected less than radius_m, {:g} m",
                                            grid.without->radius_m, grid.within->radius_m)};
  } else {
    grid.corners = clockwise(sizes.corners);
  }
  grid.z_m = [](double, double) { return 0.0; };
  return make_plan(SurfaceKind::water, grid, patch_m);
}

}  // namespace slackwater::twin
