#pragma once
#include <string>

#include "fields/base/angle.h"

namespace slackwater {

/// A place on WGS 84. Longitude in [-180, 180). Depth and height are counted from mean sea level,
/// elsewhere.
struct GeoPoint {
  Angle latitude;
  Angle longitude;

  /// Normalises the longitude; throws Error(invalid_input) for |latitude| > 90 or a value that is
  /// not finite.
  [[nodiscard]] static GeoPoint from_degrees(double latitude_deg, double longitude_deg);
  [[nodiscard]] double latitude_deg() const noexcept { return latitude.degrees(); }
  [[nodiscard]] double longitude_deg() const noexcept { return longitude.degrees(); }
  bool operator==(const GeoPoint&) const = default;
};

/// The same longitude in [-180, 180).
[[nodiscard]] double normalised_longitude_deg(double longitude_deg) noexcept;

/// A box of latitude and longitude; `west > east` means that it crosses the antimeridian.
struct BoundingBox {
  double west_deg = -180;
  double south_deg = -90;
  double east_deg = 180;
  double north_deg = 90;

  [[nodiscard]] bool contains(const GeoPoint& point) const noexcept;
  /// Throws Error(invalid_input) unless -90 <= south <= north <= 90 and |west|, |east| <= 360.
  [[nodiscard]] static BoundingBox from_degrees(double west, double south, double east,
                                                double north);
  bool operator==(const BoundingBox&) const = default;
};

/// "48.8500 N 2.5500 W": a place for people.
[[nodiscard]] std::string position_text(const GeoPoint& point);

/// Geodesic distance on WGS 84, metres (PROJ).
[[nodiscard]] double distance_m(const GeoPoint& a, const GeoPoint& b);

}  // namespace slackwater
