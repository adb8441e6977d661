#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/surface/cleaning.h"

namespace slackwater::twin {
namespace {

using constants::degree;

double read_down(const Config& level) {
  const auto deep = level.optional_number("depth_m", {0, 12000});
  const auto high = level.optional_number("height_m", {0, 500});
  if (deep.has_value() == high.has_value())
    level.refuse("depth_m", "give one of depth_m and height_m");
  return deep ? *deep : -*high;
}

void read_bearings(const Config& config, CleaningPlan& plan) {
  plan.arc_rad = 2 * constants::pi;
  if (!config.has("bearings_deg")) return;
  const std::vector<double> bearings = config.numbers("bearings_deg", {-360, 720});
  if (bearings.size() != 2)
    config.refuse("bearings_deg", formatted("found {} bearings, expected two: from where to where, "
                                            "clockwise",
                                            bearings.size()));
  const double arc_deg = bearings[1] - bearings[0];
  if (!(arc_deg > 0 && arc_deg <= 360))
    config.refuse("bearings_deg", formatted("goes round by {:g} degrees, expected more than 0 and "
                                            "at most 360; across north write [350, 370]",
                                            arc_deg));
  plan.from_rad = bearings[0] * degree;
  plan.arc_rad = arc_deg * degree;
}

}  // namespace

CleaningPlan read_cleaning(const Config& config) {
  CleaningPlan plan;
  read_bearings(config, plan);
  plan.top_m = read_down(config.child("from"));
  plan.bottom_m = read_down(config.child("to"));
  if (!(plan.bottom_m > plan.top_m))
    config.refuse("to", "is not below from; give the upper edge of the patch first");
  plan.tool = read_cleaning_tool(config.child("tool"));
  plan.growth = read_marine_growth(config.child("growth"));
  plan.cell_m = config.optional_number("cell_m", {0.001, 1}).value_or(plan.cell_m);
  if (plan.cell_m > plan.tool.swath_m)
    config.refuse("cell_m", formatted("found {:g} m, wider than the tool's {:g} m; take a quarter "
                                      "of that",
                                      plan.cell_m, plan.tool.swath_m));
  plan.band_m = config.optional_number("band_m", {0.1, 1000}).value_or(plan.band_m);
  plan.clean_below_mm = config.optional_number("clean_below_mm", {0, 500}).value_or(0);
  plan.done_at = config.optional_number("done_at", {0, 1}).value_or(plan.done_at);
  return plan;
}

}  // namespace slackwater::twin
