#include "fields/geo/coverage.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/turn.h"

namespace slackwater {
namespace {

/// Degrees from west to east, eastward; 360 for a box round the Earth.
double longitude_extent_deg(const BoundingBox& box) noexcept {
  if (box.east_deg - box.west_deg >= 360) return 360;
  return compass_deg(box.east_deg - box.west_deg);
}

/// Whether the box holds the meridian; boxes that touch do, whatever the rounding.
bool reaches(const BoundingBox& box, double longitude_deg) noexcept {
  constexpr double rounding_deg = 1e-9;                          // 0.1 mm
  const double way = compass_deg(longitude_deg - box.west_deg);  // eastward
  return way <= longitude_extent_deg(box) + rounding_deg || way >= 360 - rounding_deg;
}

}  // namespace

bool overlaps(const BoundingBox& a, const BoundingBox& b) noexcept {
  if (a.south_deg > b.north_deg || b.south_deg > a.north_deg) return false;
  return reaches(a, b.west_deg) || reaches(b, a.west_deg);
}

BoundingBox widened(const BoundingBox& box, double margin_km) noexcept {
  if (!(margin_km > 0)) return box;
  // Meridional curvature radius of WGS 84 is at least 6335.4 km, 0.56 % below the mean radius.
  const double margin_rad = margin_km * 1000.0 * 1.006 / constants::earth_radius_m;
  const double margin_deg = margin_rad / constants::degree;
  BoundingBox wide = box;
  wide.south_deg = std::max(-90.0, box.south_deg - margin_deg);
  wide.north_deg = std::min(90.0, box.north_deg + margin_deg);
  // A cap of angular radius d about latitude p spans asin(sin d / cos p) of longitude to either
  // side, and all of it where it holds a pole.
  const double poleward_rad =
      std::max(std::abs(box.south_deg), std::abs(box.north_deg)) * constants::degree;
  const double sine = std::sin(margin_rad) / std::cos(poleward_rad);
  const bool holds_pole = poleward_rad + margin_rad >= constants::pi / 2;
  const double aside_deg = holds_pole ? 180.0 : std::asin(std::min(1.0, sine)) / constants::degree;
  if (longitude_extent_deg(box) + 2 * aside_deg >= 360) {
    wide.west_deg = -180;
    wide.east_deg = 180;
  } else {
    wide.west_deg = box.west_deg - aside_deg;
    wide.east_deg = box.east_deg + aside_deg;
  }
  return wide;
}

BoundingBox box_of(const GeoPoint& point) noexcept {
  return {point.longitude_deg(), point.latitude_deg(), point.longitude_deg(), point.latitude_deg()};
}

}  // namespace slackwater
