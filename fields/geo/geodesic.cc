#include <geodesic.h>

#include "fields/geo/geo_point.h"

namespace slackwater {

double distance_m(const GeoPoint& a, const GeoPoint& b) {
  // WGS 84; Karney's algorithm as shipped with PROJ, exact to nanometres.
  static const geod_geodesic ellipsoid = [] {
    geod_geodesic g{};
    geod_init(&g, 6378137.0, 1.0 / 298.257223563);
    return g;
  }();
  double metres = 0;
  geod_inverse(&ellipsoid, a.latitude_deg(), a.longitude_deg(), b.latitude_deg(), b.longitude_deg(),
               &metres, nullptr, nullptr);
  return metres;
}

}  // namespace slackwater
