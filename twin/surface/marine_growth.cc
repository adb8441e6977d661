#include "twin/surface/marine_growth.h"

#include <limits>

namespace slackwater::twin {

double MarineGrowth::thickness_mm_at(double down_m) const noexcept {
  if (down_m < top_m) return 0;
  for (const Layer& layer : layers)
    if (down_m < layer.bottom_m) return layer.thickness_mm;
  return 0;
}

MarineGrowth read_marine_growth(const Config& config) {
  constexpr double all = std::numeric_limits<double>::infinity();
  MarineGrowth growth;
  growth.source = config.text("source");
  growth.status = config.text("status");
  growth.top_m = -config.optional_number("up_to_height_m", {0, 20}).value_or(0);
  // From water to shell.
  growth.density_kg_m3 = config.optional_number("density_kg_m3", {900, 3000}).value_or(0);
  double above_m = growth.top_m;
  for (const Config& entry : config.children("by_depth")) {
    if (above_m == all)
      entry.refuse("by_depth", "found below a layer without down_to_depth_m, which goes all down");
    if (entry.has("thickness"))
      entry.refuse("thickness", "has no unit; say thickness_mm, in millimetres");
    MarineGrowth::Layer layer;
    layer.bottom_m = entry.optional_number("down_to_depth_m", {0, 12000}).value_or(all);
    layer.thickness_mm = entry.number("thickness_mm", {0, 1000});
    if (layer.bottom_m <= above_m)
      entry.refuse("down_to_depth_m", "is not below the layer before it; list them from the top");
    above_m = layer.bottom_m;
    growth.layers.push_back(layer);
  }
  if (growth.layers.empty())
    config.refuse("by_depth",
                  "missing; give the growth, as in [{down_to_depth_m: 40, thickness_mm: 100}]");
  return growth;
}

}  // namespace slackwater::twin
