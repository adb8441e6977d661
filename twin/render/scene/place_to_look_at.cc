#include "twin/render/scene/place_to_look_at.h"

namespace slackwater::twin {

std::optional<Triple<double>> place_to_look_at(
    std::span<const std::shared_ptr<const Inspection>> inspections,
    const std::vector<Structure>& structures, const Triple<double>& from_m, double most_range_m) {
  std::optional<Triple<double>> place_m;
  double nearest_m = most_range_m;
  const auto take = [&](const Triple<double>& at_m) {
    const double away_m = length_of(at_m - from_m);
    if (!(away_m < nearest_m)) return;
    nearest_m = away_m;
    place_m = at_m;
  };
  for (const auto& inspection : inspections)
    for (const Surface& surface : inspection->surfaces)
      for (const Patch& patch : surface.patches) take(patch.centre_m);
  if (place_m) return place_m;
  for (const Structure& structure : structures) {
    // Down the slope of its distance, which is exact: to its surface.
    const double away_m = signed_distance_m(structure, from_m);
    constexpr double step_m = 1e-4;
    const auto slope = [&](const Triple<double>& step) {
      return (signed_distance_m(structure, from_m + step) -
              signed_distance_m(structure, from_m - step)) /
             (2 * step_m);
    };
    const Triple<double> out{slope({step_m, 0, 0}), slope({0, step_m, 0}), slope({0, 0, step_m})};
    if (away_m > 0) take(from_m - away_m * out);
  }
  return place_m;
}

}  // namespace slackwater::twin
