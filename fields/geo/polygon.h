#pragma once
#include <optional>
#include <string>
#include <vector>

#include "fields/base/frame.h"
#include "fields/geo/geo_point.h"

namespace slackwater {

/// Corners as a polygon of the plane: degrees east and north of the first one's meridian and of the
/// equator, so that a polygon across the antimeridian is one. For polygons less than 180 degrees
/// wide.
[[nodiscard]] std::vector<Horizontal> degrees_about_first(const std::vector<GeoPoint>& corners);

/// Why the corners, in order and the last joined to the first, make no simple polygon: too few, one
/// twice running, sides that cross. Nothing where they do.
[[nodiscard]] std::optional<std::string> flaw_of_polygon(const std::vector<Horizontal>& corners);

/// Whether a place lies in a polygon of the plane, its edge counted in or out. Odd crossings.
[[nodiscard]] bool is_inside(const std::vector<Horizontal>& corners, Horizontal place);
/// Whether a straight way touches it: begins, ends or passes there.
[[nodiscard]] bool leads_through(const std::vector<Horizontal>& corners, Horizontal from,
                                 Horizontal to);

}  // namespace slackwater
