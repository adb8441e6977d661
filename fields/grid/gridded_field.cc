#include "fields/grid/gridded_field.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/base/numbers/ascends.h"

namespace slackwater {
namespace {

/// A lone cell is 10 km wide (fields/docs/conventions.md: 5 km for a one-cell grid).
constexpr double lone_half_cell_m = 5000.0;

double half_step(const std::vector<double>& axis, bool last, double lone_deg) {
  if (axis.size() < 2) return lone_deg;
  return 0.5 * (last ? axis[axis.size() - 1] - axis[axis.size() - 2] : axis[1] - axis[0]);
}

}  // namespace

void expect_canonical(const Grid& grid) {
  expects(!grid.latitude_deg.empty() && !grid.longitude_deg.empty(), "a grid has rows and columns");
  expects(ascends(grid.latitude_deg), "latitudes ascend");
  expects(ascends(grid.longitude_deg), "longitudes ascend");
  expects(ascends(grid.levels_m), "levels ascend");
  expects(grid.longitude_deg.front() >= -180.0 && grid.longitude_deg.front() < 180.0,
          "the first longitude lies in [-180, 180)");
  expects(std::adjacent_find(grid.time.begin(), grid.time.end(),
                             [](const TimeCell& a, const TimeCell& b) {
                               return !(a.centre() < b.centre());
                             }) == grid.time.end(),
          "times ascend");
}

BoundingBox coverage_of(const Grid& grid) {
  constexpr double degree_m = constants::earth_radius_m * constants::pi / 180.0;
  const double lone_latitude = lone_half_cell_m / degree_m;
  const double middle =
      Angle::from_degrees(grid.latitude_deg[grid.latitude_deg.size() / 2]).radians();
  const double lone_longitude = lone_latitude / std::max(0.01, std::cos(middle));
  const double west =
      grid.longitude_deg.front() - half_step(grid.longitude_deg, false, lone_longitude);
  const double east =
      grid.longitude_deg.back() + half_step(grid.longitude_deg, true, lone_longitude);
  return BoundingBox::from_degrees(
      west,
      std::max(-90.0,
               grid.latitude_deg.front() - half_step(grid.latitude_deg, false, lone_latitude)),
      east,
      std::min(90.0, grid.latitude_deg.back() + half_step(grid.latitude_deg, true, lone_latitude)));
}

}  // namespace slackwater
