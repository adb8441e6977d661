#include "twin/risk/workability/sun_position.h"

#include <cmath>

#include "fields/base/turn.h"

namespace slackwater::twin {
namespace {

double sin_deg(double degrees) noexcept { return std::sin(degrees * constants::degree); }
double cos_deg(double degrees) noexcept { return std::cos(degrees * constants::degree); }

/// The sun among the stars, in radians, and what sidereal time needs of it.
struct Ephemeris {
  double right_ascension = 0;
  double declination = 0;
  double sidereal_deg = 0;  ///< apparent, at Greenwich
};

Ephemeris ephemeris_at(UtcTime time) noexcept {
  constexpr double unix_epoch = 2440587.5;
  constexpr double j2000 = 2451545.0;
  const double days =
      unix_epoch - j2000 + static_cast<double>(time.time_since_epoch().count()) / 86'400'000.0;
  const double t = days / 36525;
  const double mean_longitude = 280.46646 + t * (36000.76983 + 0.0003032 * t);
  const double anomaly = 357.52911 + t * (35999.05029 - 0.0001537 * t);
  const double centre = sin_deg(anomaly) * (1.914602 - t * (0.004817 + 0.000014 * t)) +
                        sin_deg(2 * anomaly) * (0.019993 - 0.000101 * t) +
                        sin_deg(3 * anomaly) * 0.000289;
  const double node = 125.04 - 1934.136 * t;  // of the moon's orbit, which the axis nods with
  const double longitude = mean_longitude + centre - 0.00569 - 0.00478 * sin_deg(node);
  const double obliquity = 23.0 + 26.0 / 60 + 21.448 / 3600 -
                           t * (46.8150 + t * (0.00059 - 0.001813 * t)) / 3600 +
                           0.00256 * cos_deg(node);
  Ephemeris sun;
  sun.right_ascension = std::atan2(cos_deg(obliquity) * sin_deg(longitude), cos_deg(longitude));
  sun.declination = std::asin(sin_deg(obliquity) * sin_deg(longitude));
  sun.sidereal_deg = 280.46061837 + 360.98564736629 * days +
                     t * t * (0.000387933 - t / 38'710'000) -
                     0.00478 * sin_deg(node) * cos_deg(obliquity);
  return sun;
}

}  // namespace

SunPosition sun_position(const GeoPoint& point, UtcTime time) noexcept {
  const Ephemeris sun = ephemeris_at(time);
  const double latitude = point.latitude.radians();
  const double hour_angle = std::fmod(sun.sidereal_deg, 360.0) * constants::degree +
                            point.longitude.radians() - sun.right_ascension;
  const double east = -std::cos(sun.declination) * std::sin(hour_angle);
  const double north = std::cos(latitude) * std::sin(sun.declination) -
                       std::sin(latitude) * std::cos(sun.declination) * std::cos(hour_angle);
  const double up = std::sin(latitude) * std::sin(sun.declination) +
                    std::cos(latitude) * std::cos(sun.declination) * std::cos(hour_angle);
  const double elevation = std::atan2(up, std::hypot(east, north)) / constants::degree;
  constexpr double horizontal_parallax_deg = 8.794 / 3600;
  const double azimuth = std::atan2(east, north) / constants::degree;
  return {elevation - horizontal_parallax_deg * cos_deg(elevation), compass_deg(azimuth)};
}

}  // namespace slackwater::twin
