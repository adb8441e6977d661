#include "fields/geo/geo_point.h"

#include <cmath>
#include <string>

#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater {

double normalised_longitude_deg(double longitude_deg) noexcept {
  if (longitude_deg >= -180.0 && longitude_deg < 180.0) return longitude_deg;
  const double turns = std::floor((longitude_deg + 180.0) / 360.0);
  const double wrapped = longitude_deg - 360.0 * turns;
  return wrapped >= 180.0 ? wrapped - 360.0 : wrapped;
}

GeoPoint GeoPoint::from_degrees(double latitude_deg, double longitude_deg) {
  if (!(std::abs(latitude_deg) <= 90.0)) {
    throw Error(ErrorKind::invalid_input, "found latitude " + std::to_string(latitude_deg) +
                                              ", expected degrees north from -90 to 90");
  }
  if (!(std::abs(longitude_deg) <= 360.0)) {
    throw Error(ErrorKind::invalid_input, "found longitude " + std::to_string(longitude_deg) +
                                              ", expected degrees east from -180 to 360");
  }
  return {Angle::from_degrees(latitude_deg),
          Angle::from_degrees(normalised_longitude_deg(longitude_deg))};
}

BoundingBox BoundingBox::from_degrees(double west, double south, double east, double north) {
  if (!(south >= -90 && south <= north && north <= 90 && std::abs(west) <= 360 &&
        std::abs(east) <= 360)) {
    throw Error(ErrorKind::invalid_input,
                "found box west " + std::to_string(west) + " south " + std::to_string(south) +
                    " east " + std::to_string(east) + " north " + std::to_string(north) +
                    ", expected degrees with -90 <= south <= north <= 90; give it as W,S,E,N");
  }
  // A box that goes once around keeps its width; others are brought to [-180, 180].
  if (east - west >= 360) return {-180, south, 180, north};
  const double normal_west = normalised_longitude_deg(west);
  double normal_east = normalised_longitude_deg(east);
  if (normal_east == -180 && east != west) normal_east = 180;
  return {normal_west, south, normal_east, north};
}

bool BoundingBox::contains(const GeoPoint& point) const noexcept {
  const double latitude = point.latitude_deg();
  if (latitude < south_deg || latitude > north_deg) return false;
  const double longitude = point.longitude_deg();
  if (west_deg <= east_deg) {
    return (longitude >= west_deg && longitude <= east_deg) ||
           (longitude + 360 >= west_deg && longitude + 360 <= east_deg);
  }
  return longitude >= west_deg || longitude <= east_deg;
}

std::string position_text(const GeoPoint& point) {
  const double latitude = point.latitude_deg();
  const double longitude = point.longitude_deg();
  return formatted("{:.4f} {} {:.4f} {}", std::abs(latitude), latitude < 0 ? "S" : "N",
                   std::abs(longitude), longitude < 0 ? "W" : "E");
}

}  // namespace slackwater
