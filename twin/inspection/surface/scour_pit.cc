#include "twin/inspection/surface/scour_pit.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/inspection/surface/surface_builder.h"
#include "twin/inspection/surface/usual_sizes.h"

namespace slackwater::twin {
namespace {

using constants::degree;
/// Of the pile's diameter: the mean of 1.3 and twice its standard deviation of 0.7 for piles in a
/// current, Sumer, Fredsoe & Christiansen (1992).
constexpr double deepest = 2.7;

}  // namespace

double ScourPit::z_m(double north_at_m, double east_at_m) const noexcept {
  if (!(depth_m > 0)) return bed_m;
  const double north = north_at_m - north_m, east = east_at_m - east_m;
  const double off_m = std::hypot(north, east) - pile_radius_m;
  if (off_m >= width_m) return bed_m;
  const double here_m = depth_m * (1 + skew * std::cos(std::atan2(east, north) - deepest_rad));
  return bed_m + here_m * (1 - std::max(off_m, 0.0) / width_m);
}

double ScourPit::volume_m3() const noexcept {
  return 2 * constants::pi * depth_m * width_m * (pile_radius_m / 2 + width_m / 6);
}

ScourPit scour_pit(const BedSizes::Scour& sizes, const ScourPit& level_bed) {
  ScourPit pit = level_bed;
  pit.depth_m = sizes.depth_m;
  const double most_m = deepest * 2 * pit.pile_radius_m;
  if (pit.depth_m > most_m)
    throw Unmakeable{"scour.depth_m",
                     formatted("found {:g} m, expected at most {:.1f} m: {:g} diameters of the "
                               "foundation; correct it",
                               pit.depth_m, most_m, deepest)};
  const double slope_rad = sizes.slope_rad.value_or(degree * usual::slope_deg);
  pit.width_m = sizes.width_m.value_or(pit.depth_m / std::tan(slope_rad));
  pit.skew = sizes.skew.value_or(0);
  pit.deepest_rad = sizes.deepest_rad.value_or(0);
  return pit;
}

}  // namespace slackwater::twin
