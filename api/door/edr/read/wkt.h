#pragma once
#include <cstddef>
#include <initializer_list>
#include <string_view>

#include "api/door/edr/read/geometry.h"

namespace slackwater::api::edr {

constexpr std::size_t max_wkt_bytes = std::size_t{64} * 1024;
constexpr std::size_t max_wkt_vertices = 10'000;
/// Metres above or below mean sea level that a Z may have.
constexpr double max_vertical_m = 20'000;

/// The geometry of `coords`, Well Known Text (OGC 06-103r4, 7) in longitude and latitude:
///
///   POINT(2.45 57.25)   MULTIPOINT((2 57),(3 58)) or MULTIPOINT(2 57,3 58)
///   LINESTRING Z(2 57 10,3 58 20)
///   POLYGON((2 57,3 57,3 58,2 57),(hole))   MULTILINESTRING(...)   MULTIPOLYGON(...)
///
/// Letters in either case; Z, M and ZM after a blank or attached (LINESTRINGZM). Z: the
/// collection's vertical coordinate, within max_vertical_m. M: seconds since
/// 1970-01-01T00:00:00Z, which never go back along a line. Longitudes in [-180, 360], see
/// `Vertex`; latitudes in [-90, 90]; rings have four vertices at least and end where they start,
/// lines two. Orientation of rings does not matter.
///
/// Throws Error(usage) that names `parameter`, the character (counted from 1) where the text goes
/// wrong and what was expected there; also for EMPTY, other geometries, a type that is not among
/// `allowed`, and beyond the limits above.
/// Cost: one pass, no recursion.
[[nodiscard]] Geometry parse_wkt(std::string_view parameter, std::string_view text,
                                 std::initializer_list<GeometryType> allowed = {});

}  // namespace slackwater::api::edr
