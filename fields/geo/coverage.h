#pragma once
#include "fields/geo/geo_point.h"

namespace slackwater {

/// Whether two boxes share a point. Longitudes in any convention (0..360, ±180, across the
/// antimeridian).
[[nodiscard]] bool overlaps(const BoundingBox& a, const BoundingBox& b) noexcept;

/// A box that holds every point within `margin_km` of the box, on a sphere of the mean Earth radius
/// enlarged by 0.6 % so that no geodesic on WGS 84 is shorter. It may hold a little more, never
/// less.
[[nodiscard]] BoundingBox widened(const BoundingBox& box, double margin_km) noexcept;

/// The box without extent.
[[nodiscard]] BoundingBox box_of(const GeoPoint& point) noexcept;

}  // namespace slackwater
