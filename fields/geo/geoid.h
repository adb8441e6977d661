#pragma once
#include "fields/geo/geo_point.h"

namespace slackwater {

/// Height of the geoid, which stands for mean sea level, above the WGS 84 ellipsoid, m. EGM96 on a
/// grid of 15' (PROJ's `egm96_15.gtx`), bilinear: within about a metre of the truth; altitudes of
/// satellite receivers need it, nothing else does.
/// @throws Error(unavailable) where the grid is not installed (package proj-data)
[[nodiscard]] double geoid_height_m(const GeoPoint& point);

}  // namespace slackwater
