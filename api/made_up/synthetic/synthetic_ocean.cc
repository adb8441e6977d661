#include "api/made_up/synthetic/synthetic_ocean.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"

namespace slackwater::api {
namespace {

constexpr double spin_up_h =
    8 * 24;  ///< the column forgets within two days; its start is out of sight
constexpr double margin_h =
    48;  ///< the truth begins a day before the first day, and systems arrive early

ColumnPhysics physics_of(const SyntheticOceanSettings& settings) {
  expects(settings.days > 0 && settings.days <= 400,
          "a synthetic ocean lasts between 1 and 400 days");
  expects(
      settings.site_mixing.eddy_viscosity_m2_s > 0 && settings.site_mixing.bottom_friction_m_s > 0,
      "viscosity and bottom friction are positive");
  return {.coriolis_rad_s =
              2 * constants::earth_rotation_rad_s * std::sin(settings.site.latitude.radians()),
          .reference_depth_m = settings.site_depth_m,
          .reference = settings.site_mixing};
}

/// Air over water density times the coefficient of the drag law (physics section 2), per power of
/// the wind speed.
constexpr double density_ratio = constants::air_density_kg_m3 / constants::sea_water_density_kg_m3;
constexpr double quadratic_drag = 0.79e-3 * density_ratio;
constexpr double cubic_drag_s_m = 0.08e-3 * density_ratio;

WindDrivenColumn driven_by(const ColumnPhysics& physics, const Weather& weather, int days,
                           double coefficient, int extra_power) {
  return {physics, -spin_up_h, days * 24.0 + margin_h,
          [&weather, coefficient, extra_power](double hours) {
            const Horizontal wind = weather.site_wind_m_s(hours);
            return coefficient * std::pow(std::abs(wind), extra_power) * wind;
          }};
}

using constants::nan;

}  // namespace

OceanModelError::OceanModelError(const RandomVectorField& analysis, std::uint64_t run_seed,
                                 UtcTime epoch, UtcTime issued)
    : analysis_(&analysis),
      growth_({.component_sigma_m_s = 0.015,
               .shortest_period_h = 10,
               .longest_period_h = 80,
               .shortest_wavelength_m = 6e4},
              run_seed, "synthetic/model_forecast/" + format_utc(issued)),
      epoch_(epoch),
      issued_(issued) {}

Horizontal OceanModelError::at(PlanePoint point, UtcTime time) const noexcept {
  const double hours = hours_between(epoch_, time);
  const double lead_days = std::max(hours_between(issued_, time), 0.0) / 24;
  return analysis_->at(point, hours) + lead_days * growth_.at(point, hours);
}

SyntheticOcean::SyntheticOcean(const SyntheticOceanSettings& settings)
    : settings_(settings),
      epoch_(settings.first_day),
      physics_(physics_of(settings)),
      coast_(settings.site, settings.site_depth_m),
      weather_(settings.seed, epoch_),
      waves_(weather_, settings.seed, -spin_up_h, settings.days * 24.0 + margin_h),
      interior_({.component_sigma_m_s = 0.04,
                 .shortest_period_h = 70,
                 .longest_period_h = 300,
                 .shortest_wavelength_m = 1.5e5,
                 .terms = 6},
                settings.seed, "synthetic/interior"),
      analysis_error_({.component_sigma_m_s = 0.012,
                       .shortest_period_h = 8,
                       .longest_period_h = 60,
                       .shortest_wavelength_m = 4e4},
                      settings.seed, "synthetic/model_error"),
      quadratic_(driven_by(physics_, weather_, settings.days, quadratic_drag, 1)),
      cubic_(driven_by(physics_, weather_, settings.days, cubic_drag_s_m, 2)) {}

double SyntheticOcean::checked_hours(UtcTime time) const {
  expects(time >= begin() && time <= end(), "the synthetic truth is asked within its days");
  return hours_since_epoch(time);
}

Horizontal SyntheticOcean::interior_far_from_bed(PlanePoint point, double hours) const noexcept {
  return Horizontal{0.05, 0.02} + interior_.at(point, hours);
}

Horizontal SyntheticOcean::wind_driven(PlanePoint point, double water_depth_m, double depth_m,
                                       double hours) const noexcept {
  // The wind here is a gain times the site's wind a little earlier, so its stress splits into two
  // powers of the gain and the response, being linear, into two tables.
  const double gain = Weather::offshore_gain(point);
  const double earlier = hours - Weather::arrival_delay_h(point);
  return gain * gain * quadratic_.velocity(water_depth_m, depth_m, earlier) +
         gain * gain * gain * cubic_.velocity(water_depth_m, depth_m, earlier);
}

std::optional<Horizontal> SyntheticOcean::current_truth(const GeoPoint& point, double depth_m,
                                                        UtcTime time) const {
  Horizontal velocity;
  CurrentSeries(*this, point, {&depth_m, 1}).at(time, {&velocity, 1});
  if (std::isnan(velocity.real())) return std::nullopt;
  return velocity;
}

std::optional<Horizontal> SyntheticOcean::wind_driven_truth(const GeoPoint& point, double depth_m,
                                                            UtcTime time) const {
  const PlanePoint place = coast_.plane(point);
  const double water_m = coast_.depth_m(place);
  const double hours = checked_hours(time);
  if (coast_.is_land(place) || depth_m < 0 || depth_m > water_m) return std::nullopt;
  return wind_driven(place, water_m, depth_m, hours);
}

Horizontal SyntheticOcean::wind_truth(const GeoPoint& point, UtcTime time) const {
  return weather_.wind_m_s(coast_.plane(point), checked_hours(time));
}

std::optional<SyntheticSea> SyntheticOcean::sea_truth(const GeoPoint& point, UtcTime time) const {
  const PlanePoint place = coast_.plane(point);
  const double hours = checked_hours(time);
  if (coast_.is_land(place)) return std::nullopt;
  return waves_.sea(coast_.distance_offshore_m(place), hours);
}

std::optional<double> SyntheticOcean::elevation_truth_m(const GeoPoint& point, UtcTime time) const {
  const PlanePoint place = coast_.plane(point);
  if (coast_.is_land(place)) return std::nullopt;
  return Tide::elevation_m(place, Tide::arguments(time));
}

double SyntheticOcean::water_depth_m(const GeoPoint& point) const {
  return coast_.depth_m(coast_.plane(point));
}

bool SyntheticOcean::is_land(const GeoPoint& point) const {
  return coast_.is_land(coast_.plane(point));
}

ColumnMixing SyntheticOcean::mixing_truth(const GeoPoint& point) const {
  return physics_.at_depth(water_depth_m(point));
}

OceanModelError SyntheticOcean::model_error(UtcTime issued) const {
  return {analysis_error_, settings_.seed, epoch_, issued};
}

WeatherForecast SyntheticOcean::weather_forecast(UtcTime issued) const {
  return {weather_, settings_.seed, epoch_, issued};
}

CurrentSeries::CurrentSeries(const SyntheticOcean& ocean, const GeoPoint& point,
                             std::span<const double> depths_m)
    : ocean_(&ocean),
      point_(ocean.coast_.plane(point)),
      water_depth_m_(ocean.coast_.depth_m(point_)) {
  const bool land = ocean.coast_.is_land(point_);
  for (const double depth_m : depths_m) {
    const bool wet = !land && depth_m >= 0 && depth_m <= water_depth_m_;
    depth_m_.push_back(wet ? depth_m : nan);
    tide_.push_back(wet ? Tide::parts(ocean.physics_, point_, water_depth_m_, depth_m)
                        : Tide::RotaryParts{});
    interior_factor_.push_back(wet ? bottom_layer_factor(ocean.physics_, water_depth_m_, depth_m, 0)
                                   : nan);
  }
}

void CurrentSeries::at(UtcTime time, std::span<Horizontal> velocity_m_s) const {
  expects(velocity_m_s.size() == depth_m_.size(), "one velocity per depth");
  const double hours = ocean_->checked_hours(time);
  const Tide::Arguments arguments = Tide::arguments(time);
  const Horizontal interior = ocean_->interior_far_from_bed(point_, hours);
  for (std::size_t k = 0; k < depth_m_.size(); ++k) {
    velocity_m_s[k] = std::isnan(depth_m_[k])
                          ? Horizontal{nan, nan}
                          : interior * interior_factor_[k] + Tide::current(tide_[k], arguments) +
                                ocean_->wind_driven(point_, water_depth_m_, depth_m_[k], hours);
  }
}

}  // namespace slackwater::api
