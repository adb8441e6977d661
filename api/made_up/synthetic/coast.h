#pragma once
#include "api/made_up/synthetic/random_series.h"
#include "fields/geo/geo_point.h"

namespace slackwater::api {

/// The land and the bed of the synthetic ocean: a coast in the south with capes and bays, water
/// that deepens from 15 m at the coast towards 60 m offshore, with low banks along the coast,
/// exactly `site_depth_m` at the site.
///
/// Plane coordinates are those of a tangent plane with constant metres per degree at the site's
/// latitude: enough for a truth that is defined on that plane.
class Coast {
 public:
  Coast(GeoPoint site, double site_depth_m);

  [[nodiscard]] PlanePoint plane(const GeoPoint& point) const noexcept;
  /// Metres north of the coast line; negative on land.
  [[nodiscard]] double distance_offshore_m(PlanePoint point) const noexcept;
  /// Depth below mean sea level, >= 12 m; for a point on land the depth of the water at the coast
  /// (callers ask `is_land` first).
  [[nodiscard]] double depth_m(PlanePoint point) const noexcept;
  [[nodiscard]] bool is_land(PlanePoint point) const noexcept {
    return distance_offshore_m(point) <= 0;
  }
  [[nodiscard]] const GeoPoint& site() const noexcept { return site_; }

 private:
  GeoPoint site_;
  double metres_per_degree_east_ = 0;
  double slope_length_m_ = 0;
};

}  // namespace slackwater::api
