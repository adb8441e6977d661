#include <cmath>
#include <utility>

#include "twin/scenario/write_conduct.h"
#include "twin/scenario/write_number.h"

namespace slackwater::twin {
namespace {

YamlValue growth_value(const MarineGrowth& growth) {
  YamlValue value;
  value.put("source", growth.source)
      .put("status", growth.status)
      .put("up_to_height_m", -growth.top_m + 0.0);
  if (growth.density_kg_m3 > 0) value.put("density_kg_m3", growth.density_kg_m3);
  std::vector<YamlValue> layers;
  for (const MarineGrowth::Layer& layer : growth.layers) {
    YamlValue& entry = layers.emplace_back();
    if (std::isfinite(layer.bottom_m)) entry.put("down_to_depth_m", layer.bottom_m);
    entry.put("thickness_mm", layer.thickness_mm);
  }
  value.put("by_depth", std::move(layers));
  return value;
}

YamlValue tool_value(const CleaningTool& tool) {
  const auto per_hour = [](double per_second) {
    return number_for(per_second, 3600 * per_second, [](double number) { return number / 3600; });
  };
  YamlValue value;
  value.put("swath_m", tool.swath_m).put("reach_m", tool.reach_m);
  if (tool.removal_mm_m2_s > 0)
    value.put("removal_mm_m2_h", per_hour(tool.removal_mm_m2_s));
  else
    value.put("rate_m2_h", per_hour(tool.rate_m2_s));
  value.put("source", tool.source).put("status", tool.status);
  return value;
}

YamlValue look_value(const InspectionLine& line) {
  std::vector<std::string> kinds;
  for (const SurfaceKind kind : line.kinds) kinds.emplace_back(name_of(kind));
  YamlValue value;
  value.put("instrument", line.instrument)
      .put("kinds", YamlValue::words(kinds))
      .put("detail_mm", multiple_for(line.detail_m, 1e-3))
      .put("incidence_deg", degrees_for(line.most_incidence_rad))
      .put("looks", static_cast<double>(line.looks))
      .put("seen_at", line.seen_at);
  return value;
}

YamlValue clarity_value(const Clarity& clarity) {
  YamlValue value;
  value.put("beam_attenuation_per_m", clarity.beam_attenuation_per_m)
      .put("daylight", clarity.daylight)
      .put("diffuse_attenuation_per_m", clarity.diffuse_attenuation_per_m)
      .put("backscatter_per_m", clarity.backscatter_per_m);
  return value;
}

YamlValue span_value(const Range& span) { return YamlValue::numbers({span.low, span.high}); }

YamlValue defects_value(const PlannedDefects& entry) {
  YamlValue value;
  value.put("kind", name_of(entry.kind));
  if (!entry.surface.empty()) value.put("on", entry.surface);
  if (!entry.place) {
    value.put("count", static_cast<double>(entry.count));
  } else if (entry.place->is_by_bearing) {
    value.put("bearing_deg", degrees_for(entry.place->bearing_rad));
    put_level(entry.place->z_m, value);
  } else {
    value.put("along_m", entry.place->along_m).put("down_m", entry.place->down_m);
  }
  if (entry.size_m) value.put("size_m", span_value(*entry.size_m));
  if (entry.severity) value.put(severity_key_of(entry.kind), span_value(*entry.severity));
  return value;
}

}  // namespace

YamlValue cleaning_value(const CleaningPlan& plan) {
  YamlValue value;
  value.put("bearings_deg", bearings_value(plan.from_rad, plan.arc_rad))
      .put("from", level_value(plan.top_m))
      .put("to", level_value(plan.bottom_m))
      .put("cell_m", plan.cell_m)
      .put("band_m", plan.band_m)
      .put("clean_below_mm", plan.clean_below_mm)
      .put("done_at", plan.done_at)
      .put("growth", growth_value(plan.growth))
      .put("tool", tool_value(plan.tool));
  return value;
}

YamlValue inspection_value(const InspectionPlan& plan) {
  std::vector<YamlValue> surfaces, looks, defects;
  for (const PlannedSurface& surface : plan.surfaces) surfaces.push_back(surface_value(surface));
  for (const InspectionLine& line : plan.lines) looks.push_back(look_value(line));
  for (const PlannedDefects& entry : plan.defects.entries) defects.push_back(defects_value(entry));
  YamlValue value;
  value.put("surfaces", std::move(surfaces)).put("looks", std::move(looks));
  if (plan.water != Clarity{}) value.put("water", clarity_value(plan.water));
  if (plan.air != Clarity{}) value.put("air", clarity_value(plan.air));
  if (!defects.empty()) value.put("defects", std::move(defects));
  value.put("defect_facts", plan.defect_facts);
  if (!plan.detection.empty()) value.put("detection", YamlValue::words(plan.detection));
  if (plan.patch_m) value.put("patch_m", *plan.patch_m);
  if (plan.rays_per_look) value.put("rays_per_look", static_cast<double>(*plan.rays_per_look));
  return value;
}

}  // namespace slackwater::twin
