#include "api/door/edr/read/geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fields/base/check.h"
#include "fields/base/turn.h"

namespace slackwater::api::edr {
namespace {

enum class Side { outside, border, inside };

/// Even-odd rule: counts the edges that a ray to the east crosses. Half-open in latitude, so that a
/// vertex on the ray counts once.
Side side_of(const Path& ring, double x, double y) noexcept {
  bool is_inside = false;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
    const double x0 = ring[i].longitude_deg - x;
    const double y0 = ring[i].latitude_deg - y;
    const double x1 = ring[i + 1].longitude_deg - x;
    const double y1 = ring[i + 1].latitude_deg - y;
    const double cross = x0 * y1 - x1 * y0;
    const bool within = std::min(x0, x1) <= 0 && std::max(x0, x1) >= 0 && std::min(y0, y1) <= 0 &&
                        std::max(y0, y1) >= 0;
    if (cross == 0 && within) return Side::border;
    // Upward edges with the point on their left, downward ones with it on their right.
    if ((y0 > 0) != (y1 > 0) && (cross > 0) == (y1 > y0)) is_inside = !is_inside;
  }
  return is_inside ? Side::inside : Side::outside;
}

bool polygon_contains(const Part& rings, double x, double y) noexcept {
  if (rings.empty() || side_of(rings.front(), x, y) == Side::outside) return false;
  return std::none_of(rings.begin() + 1, rings.end(),
                      [&](const Path& hole) { return side_of(hole, x, y) == Side::inside; });
}

/// The longitudes in [-360, 360] that name the same place as one in any convention.
std::array<double, 3> names_of_longitude(double longitude_deg) noexcept {
  const double principal = short_way_deg(longitude_deg);
  return {principal, principal + 360.0, principal - 360.0};
}

}  // namespace

std::string_view name_of(GeometryType type) noexcept {
  switch (type) {
    case GeometryType::point:
      return "POINT";
    case GeometryType::multi_point:
      return "MULTIPOINT";
    case GeometryType::line_string:
      return "LINESTRING";
    case GeometryType::multi_line_string:
      return "MULTILINESTRING";
    case GeometryType::polygon:
      return "POLYGON";
    case GeometryType::multi_polygon:
      return "MULTIPOLYGON";
  }
  return "geometry";
}

Box bounding_box(const Geometry& geometry) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box box{infinity, infinity, -infinity, -infinity};
  for (const Part& part : geometry.parts) {
    for (const Path& path : part) {
      for (const Vertex& vertex : path) {
        box.west_deg = std::min(box.west_deg, vertex.longitude_deg);
        box.east_deg = std::max(box.east_deg, vertex.longitude_deg);
        box.south_deg = std::min(box.south_deg, vertex.latitude_deg);
        box.north_deg = std::max(box.north_deg, vertex.latitude_deg);
      }
    }
  }
  expects(box.west_deg <= box.east_deg, "bounding_box: a geometry with a vertex");
  return box;
}

bool contains(const Box& box, double longitude_deg, double latitude_deg) noexcept {
  if (!(latitude_deg >= box.south_deg && latitude_deg <= box.north_deg)) return false;
  const auto names = names_of_longitude(longitude_deg);
  return std::any_of(names.begin(), names.end(),
                     [&](double name) { return name >= box.west_deg && name <= box.east_deg; });
}

bool contains(const Geometry& polygons, double longitude_deg, double latitude_deg) noexcept {
  if (polygons.type != GeometryType::polygon && polygons.type != GeometryType::multi_polygon) {
    return false;
  }
  const auto names = names_of_longitude(longitude_deg);
  return std::any_of(names.begin(), names.end(), [&](double name) {
    return std::any_of(polygons.parts.begin(), polygons.parts.end(), [&](const Part& rings) {
      return polygon_contains(rings, name, latitude_deg);
    });
  });
}

}  // namespace slackwater::api::edr
