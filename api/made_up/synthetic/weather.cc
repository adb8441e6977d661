#include "api/made_up/synthetic/weather.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"

namespace slackwater::api {
namespace {

constexpr double system_speed_m_s = 12;  ///< eastward speed of the depressions

double wave(double hours, double period_h, double phase) noexcept {
  return std::sin(2 * constants::pi * hours / period_h + phase);
}

}  // namespace

Weather::Weather(std::uint64_t run_seed, UtcTime epoch) {
  Rng rng(run_seed, "synthetic/weather/" + format_utc(epoch));
  for (double& phase : phase_) phase = rng.uniform(0, 2 * constants::pi);
}

Horizontal Weather::site_wind_m_s(double hours) const noexcept {
  const double speed = 11 + 4 * wave(hours, 79, phase_[0]) + 1.3 * wave(hours, 33, phase_[1]) +
                       0.7 * wave(hours, 13, phase_[2]);
  const double from_deg = 245 + 55 * wave(hours, 97, phase_[3]) + 18 * wave(hours, 37, phase_[4]) +
                          7 * wave(hours, 17, phase_[5]);
  return vector_from_direction(speed, from_deg);
}

double Weather::offshore_gain(PlanePoint point) noexcept {
  return 1 + 0.06 * std::tanh(point.north_m / 15000);
}

double Weather::arrival_delay_h(PlanePoint point) noexcept {
  return point.east_m / system_speed_m_s / 3600;
}

WeatherForecast::WeatherForecast(const Weather& weather, std::uint64_t run_seed, UtcTime epoch,
                                 UtcTime issued)
    : weather_(&weather),
      error_({.component_sigma_m_s = 1,
              .shortest_period_h = 9,
              .longest_period_h = 60,
              .shortest_wavelength_m = 3e5},
             run_seed, "synthetic/weather_forecast/" + format_utc(issued)),
      issued_h_(hours_between(epoch, issued)) {}

double WeatherForecast::component_sigma_m_s(double lead_h) noexcept {
  return 0.4 + 0.6 * std::max(lead_h, 0.0) / 24;
}

Horizontal WeatherForecast::wind_m_s(PlanePoint point, double hours) const noexcept {
  return weather_->wind_m_s(point, hours) +
         component_sigma_m_s(hours - issued_h_) * unit_error(point, hours);
}

}  // namespace slackwater::api
