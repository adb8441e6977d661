#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/inspection/surface/plan_grid.h"
#include "twin/inspection/surface/read_shape.h"
#include "twin/inspection/surface/shapes.h"

namespace slackwater::twin {
namespace {

constexpr Range of_a_corner{-1e6, 1e6};

/// Clockwise; refused where they are not round a convex piece.
std::vector<Triple<double>> read_corners(const Config& config) {
  std::vector<Triple<double>> corners;
  for (const Config& corner : config.children("corners"))
    corners.push_back(
        {corner.number("north_m", of_a_corner), corner.number("east_m", of_a_corner), 0});
  const std::size_t n = corners.size();
  if (n < 3) config.refuse("corners", formatted("found {}, expected at least three", n));
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
    config.refuse("corners", "go round a piece that is not convex; cut it into several surfaces");
  if (turns_left) std::reverse(corners.begin(), corners.end());
  return corners;
}

}  // namespace

Surface make_water(const Config& config, double patch_m) {
  PlanGrid grid;
  if (config.has("corners") == config.has("radius_m"))
    config.refuse("radius_m", "give one of radius_m and corners");
  if (config.has("corners")) {
    grid.corners = read_corners(config);
  } else {
    grid.within =
        PlanCircle{config.number("north_m", of_a_corner), config.number("east_m", of_a_corner),
                   config.number("radius_m", {1, 20000})};
    if (const auto inner_m = config.optional_number("inner_m", {0, 20000}); inner_m.value_or(0) > 0)
      grid.without = PlanCircle{grid.within->north_m, grid.within->east_m, *inner_m};
    if (grid.without && grid.without->radius_m >= grid.within->radius_m)
      config.refuse("inner_m", formatted("found {:g} m, expected less than radius_m, {:g} m",
                                         grid.without->radius_m, grid.within->radius_m));
  }
  grid.z_m = [](double, double) { return 0.0; };
  return make_plan(SurfaceKind::water, grid, patch_m);
}

}  // namespace slackwater::twin
