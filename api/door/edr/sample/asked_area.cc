#include "api/door/edr/sample/asked_area.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/geo/geo_point.h"

namespace slackwater::api::edr {

AskedArea shape_of(const Box& box) {
  return {box, [](double, double) { return true; }, 1};
}

AskedArea shape_of(Geometry polygons) {
  AskedArea shape;
  shape.box = bounding_box(polygons);
  shape.vertices = 0;
  for (const Part& part : polygons.parts)
    for (const Path& path : part) shape.vertices += path.size();
  shape.is_inside = [polygons = std::move(polygons)](double x, double y) {
    return contains(polygons, x, y);
  };
  return shape;
}

AskedArea circle(double longitude_deg, double latitude_deg, double radius_m) {
  const double north_deg = radius_m / (constants::earth_radius_m * constants::degree);
  const double cosine = std::max(0.01, std::cos(latitude_deg * constants::degree));
  const double east_deg = std::min(180.0, north_deg / cosine);
  const Box box{longitude_deg - east_deg, std::max(-90.0, latitude_deg - north_deg),
                longitude_deg + east_deg, std::min(90.0, latitude_deg + north_deg)};
  const GeoPoint from = GeoPoint::from_degrees(latitude_deg, longitude_deg);
  return {box,
          [from, radius_m](double x, double y) {
            return distance_m(from, GeoPoint::from_degrees(y, x)) <= radius_m;
          },
          1};
}

double in_box(double longitude_deg, const Box& box) noexcept {
  const double middle = 0.5 * (box.west_deg + box.east_deg);
  return longitude_deg + 360.0 * std::round((middle - longitude_deg) / 360.0);
}

Box shared(const Box& asked, const Box& area) noexcept {
  Box cut{1, std::max(asked.south_deg, area.south_deg), 0,
          std::min(asked.north_deg, area.north_deg)};
  if (asked.east_deg - asked.west_deg >= 360) {
    constexpr double rounding_deg = 1e-3;  // of axes of single precision, with room
    const bool goes_round = area.east_deg - area.west_deg >= 360 - rounding_deg;
    cut.west_deg = goes_round ? asked.west_deg : area.west_deg;
    cut.east_deg = goes_round ? asked.west_deg + 360 : area.east_deg;
    return cut;
  }
  for (const double turn : {-720.0, -360.0, 0.0, 360.0, 720.0}) {
    const double west = std::max(asked.west_deg, area.west_deg + turn);
    const double east = std::min(asked.east_deg, area.east_deg + turn);
    if (west > east) continue;
    const bool is_second = cut.west_deg <= cut.east_deg;
    cut.west_deg = is_second ? asked.west_deg : west;
    cut.east_deg = is_second ? asked.east_deg : east;
  }
  return cut;
}

std::vector<double> even_axis(double low, double high, std::size_t count) {
  if (count == 1 || !(high > low)) return {0.5 * (low + high)};
  std::vector<double> axis(count);
  for (std::size_t i = 0; i < count; ++i)
    axis[i] = low + (high - low) * static_cast<double>(i) / static_cast<double>(count - 1);
  return axis;
}

Axes some_place_in(const Box& box, const std::function<bool(double, double)>& is_inside) {
  constexpr std::size_t fine = 33;
  const double x = 0.5 * (box.west_deg + box.east_deg);
  const double y = 0.5 * (box.south_deg + box.north_deg);
  if (is_inside(x, y)) return {{x}, {y}};
  for (const double yy : even_axis(box.south_deg, box.north_deg, fine)) {
    for (const double xx : even_axis(box.west_deg, box.east_deg, fine)) {
      if (is_inside(xx, yy)) return {{xx}, {yy}};
    }
  }
  return {{x}, {y}};
}

}  // namespace slackwater::api::edr
