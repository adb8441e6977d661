#include <algorithm>
#include <cmath>

#include "api/door/edr/read/bad_parameter.h"
#include "api/door/edr/read/bbox.h"
#include "api/door/edr/read/distance.h"
#include "api/door/edr/read/resolution.h"
#include "api/door/edr/read/vertical.h"
#include "api/door/edr/read/wkt.h"
#include "api/door/edr/sample/asked_area.h"
#include "api/door/edr/sample/queries.h"
#include "fields/base/error.h"

// Area, radius and cube: the forecast's own columns within a shape, or an even grid over it where a
// resolution is asked for or no column lies inside.

namespace slackwater::api::edr {
namespace {

using Inside = std::function<bool(double, double)>;

void add(std::vector<double>& axis, double value) {
  for (const double known : axis)
    if (std::abs(known - value) < 2e-5) return;
  axis.push_back(value);
}

/// The columns of the forecast within the shape, as axes of a grid.
Axes columns_within(const Selection& s, const Box& box, const Inside& is_inside) {
  Axes axes;
  for (const ForecastColumn& column : s.field->snapshot().columns) {
    const double x = in_box(column.point.longitude_deg(), box);
    const double y = column.point.latitude_deg();
    if (!contains(box, x, y) || !is_inside(x, y)) continue;
    add(axes.longitude_deg, x);
    add(axes.latitude_deg, y);
  }
  std::sort(axes.longitude_deg.begin(), axes.longitude_deg.end());
  std::sort(axes.latitude_deg.begin(), axes.latitude_deg.end());
  return axes;
}

Box reached(const Selection& s, const Box& box, std::string_view parameter) {
  const slackwater::BoundingBox& area = s.field->range().box;
  const double east_deg = area.east_deg < area.west_deg ? area.east_deg + 360 : area.east_deg;
  const Box cut = shared(box, {area.west_deg, area.south_deg, east_deg, area.north_deg});
  if (cut.west_deg > cut.east_deg || cut.south_deg > cut.north_deg) {
    throw Error(ErrorKind::not_found, std::string(parameter) +
                                          ": found an area that the forecast does not reach; "
                                          "valid: " +
                                          s.field->range().text());
  }
  return cut;
}

QueryPoints over(Selection s, const QueryString& query, AskedArea shape, std::string_view parameter,
                 const std::vector<double>* levels = nullptr) {
  const Box box = reached(s, shape.box, parameter);
  Inside is_inside = std::move(shape.is_inside);
  const auto x_count = resolution_in(query, "resolution-x");
  const auto y_count = resolution_in(query, "resolution-y");
  Axes axes = columns_within(s, box, is_inside);
  if (axes.longitude_deg.empty()) axes = some_place_in(box, is_inside);
  if (x_count) axes.longitude_deg = even_axis(box.west_deg, box.east_deg, *x_count);
  if (y_count) axes.latitude_deg = even_axis(box.south_deg, box.north_deg, *y_count);
  std::vector<UtcTime> times = times_of(s, query);
  std::vector<double> verticals =
      levels != nullptr ? *levels : verticals_of(s, query, s.field->range().deepest_m);
  const std::size_t cells = axes.longitude_deg.size() * axes.latitude_deg.size();
  Work work = moderate_work(s, cells * times.size() * verticals.size());
  work.comparisons = moderate_comparisons(cells, shape.vertices);
  return {work, [s = std::move(s), axes = std::move(axes), times = std::move(times),
                 verticals = std::move(verticals), is_inside = std::move(is_inside)]() mutable {
            Absences absences{};
            std::vector<Coverage> coverages{on_grid(s, std::move(axes.longitude_deg),
                                                    std::move(axes.latitude_deg), times, verticals,
                                                    is_inside, absences)};
            return answer_of(std::move(s), std::move(coverages), absences);
          }};
}

}  // namespace

QueryPoints area_plan(Selection s, const QueryString& query) {
  Geometry shape = parse_wkt("coords", query.find("coords").value_or(""),
                             {GeometryType::polygon, GeometryType::multi_polygon});
  return over(std::move(s), query, shape_of(std::move(shape)), "coords");
}

QueryPoints radius_plan(Selection s, const QueryString& query) {
  const Geometry centre =
      parse_wkt("coords", query.find("coords").value_or(""), {GeometryType::point});
  const double radius_m = parse_distance_m("within", query.find("within").value_or(""),
                                           "within-units", query.find("within-units").value_or(""));
  const Vertex& middle = centre.parts.front().front().front();
  return over(std::move(s), query, circle(middle.longitude_deg, middle.latitude_deg, radius_m),
              "coords");
}

QueryPoints cube_plan(Selection s, const QueryString& query) {
  const auto text = query.find("bbox");
  if (!text)
    throw bad_parameter("bbox", "nothing", "west,south,east,north, e.g. 2.0,53.0,2.5,53.4");
  const BoundingBox cube = parse_bbox(*text);
  const bool has_vertical = s.collection->vertical != Vertical::none;
  if (has_vertical && !query.find("z") && !cube.levels)
    throw bad_parameter("z", "nothing", "levels of the cube, e.g. 0/50 or 0,10,20");
  std::vector<double> levels;
  if (has_vertical && query.find("z")) {
    levels = verticals_of(s, query, s.field->range().deepest_m);
  } else if (has_vertical) {
    levels = all_levels(*s.collection, *s.field);
    std::erase_if(levels, [&](double z) { return z < cube.levels->low || z > cube.levels->high; });
    if (levels.empty()) {
      levels = {cube.levels->low};
      if (cube.levels->high > cube.levels->low) levels.push_back(cube.levels->high);
    }
  } else {
    // EDR 1.1 asks for z with every cube; a collection without a vertical has nothing to cut by it.
    levels = {std::nan("")};
  }
  if (const auto count = resolution_in(query, "resolution-z"); count && levels.size() > 1)
    levels = even_axis(levels.front(), levels.back(), *count);
  return over(std::move(s), query, shape_of(cube.box), "bbox", &levels);
}

}  // namespace slackwater::api::edr
