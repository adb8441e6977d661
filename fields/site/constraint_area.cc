#include "fields/site/constraint_area.h"

#include <cmath>

#include "fields/base/config.h"

namespace slackwater {
namespace {

bool is_in(const Span& span, int value) {
  return span.first <= span.last ? span.first <= value && value <= span.last
                                 : value >= span.first || value <= span.last;
}

std::optional<Span> read_span(const Config& config, const char* key, Range range) {
  const std::vector<double> ends = config.numbers(key, range);
  if (!config.has(key)) return std::nullopt;
  if (ends.size() != 2 || ends[0] != std::floor(ends[0]) || ends[1] != std::floor(ends[1]))
    config.refuse(key, "expected two whole numbers, from and to, as in [4, 7]");
  return Span{static_cast<int>(ends[0]), static_cast<int>(ends[1])};
}

ConstraintArea read_area(const Config& config) {
  ConstraintArea area;
  area.id = config.text("id");
  const std::string kind = config.text("kind");
  if (kind == "traffic_lane") {
    area.kind = AreaKind::traffic_lane;
    area.direction_deg = config.optional_number("direction_deg", {-360, 360});
  } else if (kind != "exclusion") {
    config.refuse("kind", "found " + kind + ", expected exclusion or traffic_lane");
  }
  area.reason = config.optional_text("reason").value_or("");
  for (const Config& corner : config.children("polygon"))
    area.corners.push_back(GeoPoint::from_degrees(corner.number("latitude_deg", {-90, 90}),
                                                  corner.number("longitude_deg", {-180, 360})));
  if (const auto flaw = flaw_of_polygon(degrees_about_first(area.corners)))
    config.refuse("polygon", *flaw);
  area.months = read_span(config, "months", {1, 12});
  area.hours_utc = read_span(config, "hours_utc", {0, 23});
  area.below_height_m = config.optional_number("below_height_m", {0, 1000});
  return area;
}

}  // namespace

bool ConstraintArea::is_in_force(UtcTime time) const {
  const auto day = std::chrono::floor<std::chrono::days>(time);
  const std::chrono::year_month_day date(day);
  const auto hour =
      static_cast<int>(std::chrono::duration_cast<std::chrono::hours>(time - day).count());
  const auto month = static_cast<int>(static_cast<unsigned>(date.month()));
  return (!months || is_in(*months, month)) && (!hours_utc || is_in(*hours_utc, hour));
}

std::vector<ConstraintArea> read_areas(const Config& site) {
  std::vector<ConstraintArea> areas;
  for (const Config& entry : site.children("areas")) {
    areas.push_back(read_area(entry));
    for (std::size_t i = 0; i + 1 < areas.size(); ++i)
      if (areas[i].id == areas.back().id)
        entry.refuse("id", "found " + areas.back().id + " twice; name each area differently");
  }
  return areas;
}

}  // namespace slackwater
