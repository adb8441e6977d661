#include <algorithm>
#include <utility>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/inspection/inspection_plan.h"
#include "twin/inspection/instrument/clarity.h"
#include "twin/inspection/surface/planned_surface.h"

namespace slackwater::twin {
namespace {

using constants::degree;

InspectionLine read_line(const Config& config, const std::vector<PlannedSurface>& there) {
  InspectionLine line;
  line.instrument = config.text("instrument");
  for (const std::string& word : config.texts("kinds")) {
    const SurfaceKind kind = surface_kind_of(word, config, "kinds");
    if (std::none_of(there.begin(), there.end(),
                     [&](const PlannedSurface& surface) { return surface.kind() == kind; }))
      config.refuse("kinds",
                    "found " + word + ", but no surface has that name; add it to surfaces");
    line.kinds.push_back(kind);
  }
  if (line.kinds.empty()) config.refuse("kinds", "missing; say which surfaces it inspects");
  line.detail_m = 1e-3 * config.number("detail_mm", {0.001, 1e6});
  line.most_incidence_rad = degree * config.optional_number("incidence_deg", {1, 90}).value_or(90);
  line.looks = static_cast<std::uint32_t>(config.optional_integer("looks", 1, 1000).value_or(1));
  // What the share was called when a flight that saw less did not count as done.
  const auto before = config.optional_number("done_at", {0, 1});
  const auto asked = config.optional_number("seen_at", {0, 1});
  if (before && asked) config.refuse("done_at", "found beside seen_at, its new name; keep seen_at");
  line.seen_at = asked ? *asked : before.value_or(line.seen_at);
  return line;
}

/// One instrument inspects a surface once.
void expect_once_each(const std::vector<InspectionLine>& lines, const Config& config) {
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (const SurfaceKind kind : lines[i].kinds)
        if (lines[i].instrument == lines[j].instrument &&
            std::find(lines[j].kinds.begin(), lines[j].kinds.end(), kind) != lines[j].kinds.end())
          config.refuse("looks", lines[i].instrument + " inspects each " + name_of(kind) +
                                     " in two entries; make one of them");
}

}  // namespace

InspectionPlan read_inspection(const Config& config) {
  std::vector<PlannedSurface> surfaces;
  for (const Config& entry : config.children("surfaces")) {
    surfaces.push_back(read_surface(entry));
    entry.expect_all_read();
  }
  return read_inspection(config, std::move(surfaces));
}

InspectionPlan read_inspection(const Config& config, std::vector<PlannedSurface> surfaces) {
  InspectionPlan plan;
  plan.surfaces = std::move(surfaces);
  if (plan.surfaces.empty())
    config.refuse("surfaces", "missing; an inspection has at least one surface to look at");
  for (const Config& entry : config.children("looks"))
    plan.lines.push_back(read_line(entry, plan.surfaces));
  if (plan.lines.empty())
    config.refuse("looks", "missing; an inspection has at least one instrument that looks");
  expect_once_each(plan.lines, config);
  if (const auto water = config.optional_child("water")) plan.water = read_clarity(*water);
  if (const auto air = config.optional_child("air")) plan.air = read_clarity(*air, Medium::air);
  plan.defects = read_defect_plan(config);
  if (const auto facts = config.optional_text("defect_facts")) plan.defect_facts = *facts;
  plan.detection = config.texts("detection");
  if (!plan.defects.entries.empty() && plan.detection.empty())
    config.refuse("detection",
                  "missing beside defects; name methods of data/detection by which they are found");
  plan.patch_m = config.optional_number("patch_m", {0.005, 100});
  if (const auto rays = config.optional_integer("rays_per_look", 1, 2000))
    plan.rays_per_look = static_cast<std::size_t>(*rays);
  return plan;
}

}  // namespace slackwater::twin
