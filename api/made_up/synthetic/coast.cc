#include "api/made_up/synthetic/coast.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"

namespace slackwater::api {
namespace {

constexpr double coast_south_of_site_m = 12000;
constexpr double cape_amplitude_m = 3000;
constexpr double cape_wavelength_m = 42000;
constexpr double coast_depth_m = 15;
constexpr double depth_range_m = 45;
constexpr double bank_amplitude_m = 2;
constexpr double bank_wavelength_m = 17000;
constexpr double metres_per_degree_north = constants::earth_radius_m * constants::pi / 180;

}  // namespace

Coast::Coast(GeoPoint site, double site_depth_m) : site_(site) {
  expects(site_depth_m > coast_depth_m + 1 && site_depth_m < coast_depth_m + depth_range_m - 1,
          "the synthetic site lies between 16 and 59 m of water");
  metres_per_degree_east_ = metres_per_degree_north * std::cos(site.latitude.radians());
  slope_length_m_ =
      coast_south_of_site_m / std::atanh((site_depth_m - coast_depth_m) / depth_range_m);
}

PlanePoint Coast::plane(const GeoPoint& point) const noexcept {
  const double east_deg = normalised_longitude_deg(point.longitude_deg() - site_.longitude_deg());
  return {.east_m = east_deg * metres_per_degree_east_,
          .north_m = (point.latitude_deg() - site_.latitude_deg()) * metres_per_degree_north};
}

double Coast::distance_offshore_m(PlanePoint point) const noexcept {
  const double cape =
      cape_amplitude_m * std::sin(2 * constants::pi * point.east_m / cape_wavelength_m);
  return point.north_m + coast_south_of_site_m - cape;
}

double Coast::depth_m(PlanePoint point) const noexcept {
  const double offshore_m = std::max(distance_offshore_m(point), 0.0);
  // The banks vanish on the site's meridian, so that the site keeps its stated depth.
  const double bank =
      bank_amplitude_m * std::sin(2 * constants::pi * point.east_m / bank_wavelength_m);
  return coast_depth_m + depth_range_m * std::tanh(offshore_m / slope_length_m_) + bank;
}

}  // namespace slackwater::api
