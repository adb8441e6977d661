#pragma once
#include <vector>

#include "fields/geo/geo_point.h"
#include "fields/site/constraint_area.h"

namespace slackwater::api {

/// Length of the shortest way of a vessel between two places round areas that it keeps out of:
/// straight where none lies between, else by their corners, 50 m off. Where a place lies in an area
/// itself, or there is no way, it is the straight one.
///
/// On the tangent plane of the first place, which 100 km away is long by less than 0.1 %.
[[nodiscard]] double sea_way_m(const GeoPoint& from, const GeoPoint& to,
                               const std::vector<ConstraintArea>& areas);

/// The areas that keep vessels out at some time of a day: exclusion areas at sea level.
[[nodiscard]] std::vector<ConstraintArea> closed_areas(const std::vector<ConstraintArea>& areas,
                                                       UtcTime begin, UtcTime end);

}  // namespace slackwater::api
