#include "api/door/edr/sample/product_queries.h"

#include <algorithm>

#include "api/door/edr/read/bad_parameter.h"
#include "api/door/edr/read/bbox.h"
#include "api/door/edr/read/distance.h"
#include "api/door/edr/read/resolution.h"
#include "api/door/edr/sample/instrument_queries.h"
#include "api/door/edr/sample/product_filled.h"
#include "api/door/edr/sample/work.h"
#include "fields/base/text.h"

namespace slackwater::api::edr {
namespace {

Answer at_points(const std::filesystem::path& store, const Asked& asked, const Path& points,
                 bool have_own_levels) {
  const StoredProduct& product = *asked.product;
  if (product.is_measured()) return measured_near(store, asked, points);
  Places places;
  Box box{1e9, 1e9, -1e9, -1e9};
  for (const Vertex& point : points) {
    const GeoPoint at = point_of(point.longitude_deg, point.latitude_deg);
    if (!product.bounds.contains(at)) {
      throw outside(product, formatted("coords at {:.5f} {:.5f}, outside the product",
                                       point.longitude_deg, point.latitude_deg));
    }
    places.point.push_back(at);
    places.longitude_deg.push_back(point.longitude_deg);
    places.latitude_deg.push_back(point.latitude_deg);
    box = {std::min(box.west_deg, point.longitude_deg), std::min(box.south_deg, point.latitude_deg),
           std::max(box.east_deg, point.longitude_deg),
           std::max(box.north_deg, point.latitude_deg)};
  }
  const ProductView view(store, product, window_of(asked, box));
  std::vector<std::string> notes;
  std::vector<UtcTime> times = times_of(asked, view, notes);
  std::vector<double> levels = levels_of(asked, view, have_own_levels ? points : Path());
  places.has_own_levels = have_own_levels && !levels.empty();
  const std::size_t levels_each =
      places.has_own_levels ? 1 : std::max<std::size_t>(1, levels.size());
  static_cast<void>(moderate_work(asked.parameters.size(),
                                  points.size() * times.size() * levels_each, points.size()));
  return filled(asked, view, places, std::move(times), std::move(levels), std::move(notes));
}

/// The product's own cells in the shape, or an even grid over it.
Axes axes_of(const ProductView& view, const AskedArea& shape, const Box& box,
             const QueryString& query) {
  static_cast<void>(moderate_comparisons(view.longitude_deg().size() * view.latitude_deg().size(),
                                         shape.vertices));
  Axes axes;
  for (const double x : view.longitude_deg()) {
    if (std::any_of(view.latitude_deg().begin(), view.latitude_deg().end(),
                    [&](double y) { return shape.is_inside(x, y); }))
      axes.longitude_deg.push_back(x);
  }
  for (const double y : view.latitude_deg()) {
    if (std::any_of(view.longitude_deg().begin(), view.longitude_deg().end(),
                    [&](double x) { return shape.is_inside(x, y); }))
      axes.latitude_deg.push_back(y);
  }
  if (axes.longitude_deg.empty()) axes = some_place_in(box, shape.is_inside);
  if (const auto count = resolution_in(query, "resolution-x"))
    axes.longitude_deg = even_axis(box.west_deg, box.east_deg, *count);
  if (const auto count = resolution_in(query, "resolution-y"))
    axes.latitude_deg = even_axis(box.south_deg, box.north_deg, *count);
  return axes;
}

Answer over(const std::filesystem::path& store, const Asked& asked, const AskedArea& shape,
            const QueryString& query) {
  const StoredProduct& product = *asked.product;
  if (product.is_measured()) return measured_in(store, asked, shape);
  const Box box = shared(shape.box, box_of(product));
  if (box.west_deg > box.east_deg || box.south_deg > box.north_deg)
    throw outside(product, "an area that the product does not reach");
  const auto count_x = resolution_in(query, "resolution-x");
  const auto count_y = resolution_in(query, "resolution-y");
  if (count_x && count_y)
    static_cast<void>(moderate_work(asked.parameters.size(), *count_x * *count_y, 1));
  const ProductView view(store, product, window_of(asked, box));
  std::vector<std::string> notes;
  std::vector<UtcTime> times = times_of(asked, view, notes);
  std::vector<double> levels = levels_of(asked, view);
  if (const auto count = resolution_in(query, "resolution-z"); count && levels.size() > 1)
    levels = even_axis(levels.front(), levels.back(), *count);
  const Axes axes = axes_of(view, shape, box, query);
  const std::size_t cells = axes.longitude_deg.size() * axes.latitude_deg.size();
  static_cast<void>(moderate_work(
      asked.parameters.size(), cells * times.size() * std::max<std::size_t>(1, levels.size()), 1));
  static_cast<void>(moderate_comparisons(cells, shape.vertices));
  Places places;
  places.is_grid = true;
  places.longitude_deg = axes.longitude_deg;
  places.latitude_deg = axes.latitude_deg;
  for (std::size_t j = 0; j < axes.latitude_deg.size(); ++j) {
    for (std::size_t i = 0; i < axes.longitude_deg.size(); ++i) {
      const double x = axes.longitude_deg[i];
      const double y = axes.latitude_deg[j];
      if (!shape.is_inside(x, y)) continue;
      places.point.push_back(point_of(x, y));
      places.cell.push_back(j * axes.longitude_deg.size() + i);
    }
  }
  return filled(asked, view, places, std::move(times), std::move(levels), std::move(notes));
}

std::string needed(const QueryString& query, std::string_view name, std::string_view example) {
  const auto text = query.find(name);
  if (!text) throw bad_parameter(name, "nothing", example);
  return std::string(*text);
}

}  // namespace

Answer product_answer(const std::filesystem::path& store, const StoredProduct& product,
                      const QueryType& type, const QueryString& query) {
  Asked asked = asked_of(product, query);
  if (type.name == "cube") {
    const BoundingBox cube =
        parse_bbox(needed(query, "bbox", "west,south,east,north, e.g. 2.0,53.0,2.5,53.4"));
    if (vertical_of(product) == Vertical::none) {
      asked.z.reset();  // EDR 1.1 asks for z with every cube: here there is nothing to cut by it
    } else if (!asked.z && cube.levels) {
      asked.z = formatted("{}/{}", cube.levels->low, cube.levels->high);
    } else if (!asked.z) {
      throw bad_parameter("z", "nothing", "levels of the cube, e.g. 0/50 or 0,10,20");
    }
    return over(store, asked, shape_of(cube.box), query);
  }
  const std::string coords = needed(query, "coords", "Well Known Text, e.g. POINT(-2.55 48.85)");
  if (type.name == "area") {
    return over(
        store, asked,
        shape_of(parse_wkt("coords", coords, {GeometryType::polygon, GeometryType::multi_polygon})),
        query);
  }
  if (type.name == "radius") {
    const Geometry centre = parse_wkt("coords", coords, {GeometryType::point});
    const Vertex& middle = centre.parts.front().front().front();
    const double radius_m =
        parse_distance_m("within", needed(query, "within", "a distance, e.g. 5"), "within-units",
                         needed(query, "within-units", "a unit, e.g. km"));
    return over(store, asked, circle(middle.longitude_deg, middle.latitude_deg, radius_m), query);
  }
  const Geometry geometry =
      parse_wkt("coords", coords, {GeometryType::point, GeometryType::multi_point});
  const Path& points = geometry.parts.front().front();
  return at_points(store, asked, points,
                   geometry.has_vertical && !asked.z && vertical_of(product) != Vertical::none);
}

Answer product_answer_at(const std::filesystem::path& store, const StoredProduct& product,
                         const GeoPoint& place, const QueryString& query) {
  Vertex at;
  at.longitude_deg = place.longitude_deg();
  at.latitude_deg = place.latitude_deg();
  return at_points(store, asked_of(product, query), {at}, false);
}

}  // namespace slackwater::api::edr
