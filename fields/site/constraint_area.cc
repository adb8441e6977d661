#include "fields/site/constraint_area.h"

#include <cmath>

#include "fields/base/config.h"
#include "fields/base/text.h"
#include "fields/base/turn.h"

namespace slackwater {
namespace {

double cross_of(Horizontal a, Horizontal b) { return a.real() * b.imag() - a.imag() * b.real(); }

/// Whether two stretches have a point in common, ends included.
bool meet(Horizontal a, Horizontal b, Horizontal c, Horizontal d) {
  const double at_c = cross_of(b - a, c - a), at_d = cross_of(b - a, d - a);
  const double at_a = cross_of(d - c, a - c), at_b = cross_of(d - c, b - c);
  if (((at_c > 0) != (at_d > 0)) && ((at_a > 0) != (at_b > 0)) && at_c != 0 && at_d != 0)
    return true;
  const auto lies_on = [](Horizontal p, Horizontal q, Horizontal x) {
    if (cross_of(q - p, x - p) != 0) return false;
    return std::min(p.real(), q.real()) <= x.real() && x.real() <= std::max(p.real(), q.real()) &&
           std::min(p.imag(), q.imag()) <= x.imag() && x.imag() <= std::max(p.imag(), q.imag());
  };
  return lies_on(a, b, c) || lies_on(a, b, d) || lies_on(c, d, a) || lies_on(c, d, b);
}

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

/// Degrees about the first corner, so that an area across the antimeridian is one.
std::vector<Horizontal> in_degrees(const std::vector<GeoPoint>& corners) {
  std::vector<Horizontal> plane;
  for (const GeoPoint& corner : corners)
    plane.emplace_back(short_way_deg(corner.longitude_deg() - corners.front().longitude_deg()),
                       corner.latitude_deg());
  return plane;
}

void expect_simple(const Config& config, const std::vector<GeoPoint>& corners) {
  if (corners.size() < 3)
    config.refuse("polygon",
                  formatted("found {} corners, expected three and more", corners.size()));
  const std::vector<Horizontal> c = in_degrees(corners);
  const std::size_t n = c.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const bool is_beside = j == i + 1 || (i == 0 && j == n - 1);
      if (is_beside) {
        if (c[i] == c[j]) config.refuse("polygon", "found a corner twice");
        continue;
      }
      if (meet(c[i], c[(i + 1) % n], c[j], c[(j + 1) % n]))
        config.refuse("polygon", "its sides cross; list the corners in order round it");
    }
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
  expect_simple(config, area.corners);
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

bool is_inside(const std::vector<Horizontal>& corners, Horizontal place) {
  bool is_in = false;
  const std::size_t n = corners.size();
  for (std::size_t i = 0, j = n - 1; i < n; j = i++) {
    const Horizontal a = corners[i] - place, b = corners[j] - place;
    if ((a.imag() > 0) == (b.imag() > 0)) continue;
    const double crossing = a.real() - a.imag() * (b.real() - a.real()) / (b.imag() - a.imag());
    if (crossing > 0) is_in = !is_in;
  }
  return is_in;
}

bool leads_through(const std::vector<Horizontal>& corners, Horizontal from, Horizontal to) {
  if (is_inside(corners, from) || is_inside(corners, to)) return true;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++)
    if (meet(corners[j], corners[i], from, to)) return true;
  return false;
}

}  // namespace slackwater
