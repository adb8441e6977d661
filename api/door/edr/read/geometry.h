#pragma once
#include <cstddef>
#include <string_view>
#include <vector>

#include "fields/base/time.h"

namespace slackwater::api::edr {

enum class GeometryType {
  point,
  multi_point,
  line_string,
  multi_line_string,
  polygon,
  multi_polygon
};

/// "POINT", "MULTIPOLYGON": the word of WKT.
[[nodiscard]] std::string_view name_of(GeometryType type) noexcept;

/// WGS 84 longitude and latitude as the client wrote them: longitudes in [-180, 360], so that a
/// line or polygon which crosses the antimeridian is written with longitudes beyond 180.
struct Vertex {
  double longitude_deg = 0;
  double latitude_deg = 0;
  double vertical = 0;  ///< Z, in the collection's vertical reference; 0 where it was not given
  UtcTime time{};       ///< M, seconds since 1970; the epoch where it was not given
  bool operator==(const Vertex&) const = default;
};

using Path = std::vector<Vertex>;
/// One polygon: its outer ring, then its holes, each closed. One line, or
/// all points: a single path.
using Part = std::vector<Path>;

struct Geometry {
  GeometryType type = GeometryType::point;
  bool has_vertical = false;
  bool has_time = false;
  /// One per polygon or line; one that holds all points.
  std::vector<Part> parts;
};

/// Degrees. East may lie beyond 180, see `Vertex`; west <= east always.
struct Box {
  double west_deg = 0;
  double south_deg = 0;
  double east_deg = 0;
  double north_deg = 0;
  bool operator==(const Box&) const = default;
};

/// The smallest box around all vertices. The geometry has one at least.
[[nodiscard]] Box bounding_box(const Geometry& geometry);
[[nodiscard]] bool contains(const Box& box, double longitude_deg, double latitude_deg) noexcept;

/// Whether a point lies in one of the polygons and in none of its holes: edges are straight in
/// longitude and latitude (as in OGC simple features), the border of the outer ring and of holes
/// belongs to the polygon. The antimeridian: longitudes that differ by 360 are the same place, so
/// that -179 lies in a polygon from 175 to 185. Never in points or lines.
/// @param longitude_deg  any convention
/// Cost: one pass over the vertices of all rings.
[[nodiscard]] bool contains(const Geometry& polygons, double longitude_deg,
                            double latitude_deg) noexcept;

}  // namespace slackwater::api::edr
