#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/inspection/defect/defect_plan.h"

namespace slackwater::twin {
namespace {

using constants::degree;

std::optional<DefectPlace> read_place(const Config& c) {
  const bool on_sheet = c.has("along_m") || c.has("down_m");
  const bool by_bearing = c.has("bearing_deg") || c.has("depth_m") || c.has("height_m");
  if (!on_sheet && !by_bearing) return std::nullopt;
  if (on_sheet && by_bearing)
    c.refuse(c.has("along_m") ? "along_m" : "down_m",
             "give the place on the sheet (along_m, down_m) or by bearing and depth, not both");
  DefectPlace place;
  place.is_by_bearing = by_bearing;
  if (on_sheet) {
    place.along_m = c.number("along_m", {-1e5, 1e5});
    place.down_m = c.number("down_m", {-1e5, 1e5});
    return place;
  }
  place.bearing_rad = c.number("bearing_deg", {-360, 360}) * degree;
  if (c.has("depth_m") == c.has("height_m"))
    c.refuse("depth_m", "give one of depth_m and height_m");
  place.z_m = c.has("depth_m") ? c.number("depth_m", {0, 12000}) : -c.number("height_m", {0, 500});
  return place;
}

PlannedDefects read_entry(const Config& c) {
  PlannedDefects entry;
  entry.kind = read_defect_kind(c);
  entry.surface = c.optional_text("on").value_or("");
  entry.place = read_place(c);
  if (entry.place && entry.surface.empty())
    c.refuse("on", "a defect with a place needs the surface it is on");
  if (entry.place && c.has("count"))
    c.refuse("count", "a defect with a place is one; give count or a place");
  if (!entry.place) entry.count = static_cast<std::size_t>(c.integer("count", 0, 100000));
  if (c.has("size_m")) entry.size_m = read_span(c, "size_m", most_defect_size_m);
  const char* severity = severity_key_of(entry.kind);
  const bool is_share = severity_unit_of(entry.kind) == SeverityUnit::share;
  const char* other = is_share ? "severity_m" : "severity_share";
  if (c.has(other))
    c.refuse(other, formatted("the severity of {} is told as {}", name_of(entry.kind), severity));
  if (c.has(severity)) entry.severity = read_span(c, severity, most_severity_of(entry.kind));
  return entry;
}

}  // namespace

DefectPlan read_defect_plan(const Config& config) {
  DefectPlan plan;
  for (const Config& entry : config.children("defects")) plan.entries.push_back(read_entry(entry));
  return plan;
}

}  // namespace slackwater::twin
