#include "calibration/propagate/wind_error.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fields/base/check.h"
#include "fields/interpolate/temporal.h"

namespace slackwater::calibration {
namespace {

/// Independent samples' worth of belief in `wind_climate_sigma_m_s`: winds over shelf seas differ
/// by a fifth from place to place and season to season, as a standard deviation of ten samples
/// does.
constexpr double prior_samples = 10.0;

bool is_finite(Horizontal value) noexcept {
  return std::isfinite(value.real()) && std::isfinite(value.imag());
}

double extra_sigma_m_s(const WindErrorGrowth& growth, UtcTime time) {
  const auto place = place_in(growth.extra_at, time);
  if (!place) return 0;
  const double low = growth.extra_sigma_m_s[place->low];
  if (place->upper == 0) return low;
  return (1 - place->upper) * low + place->upper * growth.extra_sigma_m_s[place->low + 1];
}

}  // namespace

double WindErrorGrowth::sigma_m_s(double lead_h) const {
  expects(initial_m_s >= 0 && saturation_m_s >= initial_m_s, "the error of a wind does not shrink");
  expects(growth_time_h > 0 && growth_power > 0 && age_h >= 0,
          "the error of a wind grows in a positive time from an age >= 0");
  if (lead_h < 0) return 0.0;
  const double grown = -std::expm1(-std::pow((lead_h + age_h) / growth_time_h, growth_power));
  const double start = initial_m_s * initial_m_s;
  return std::sqrt(start + (saturation_m_s * saturation_m_s - start) * grown);
}

WindErrorGrowth analysed_wind_error() noexcept {
  WindErrorGrowth growth;
  growth.initial_m_s = 1.0;
  growth.saturation_m_s = 1.0;
  growth.memory_h = 6.0;
  return growth;
}

WindErrorGrowth forecast_wind_error(double age_h, double climate_sigma_m_s) {
  expects(age_h >= 0 && climate_sigma_m_s > 0, "a wind forecast was made by the end of D");
  WindErrorGrowth growth;
  growth.initial_m_s = 1.0;
  growth.saturation_m_s = std::max(1.0, std::numbers::sqrt2 * climate_sigma_m_s);
  growth.growth_time_h = 204.0;
  growth.growth_power = 2.0;
  growth.memory_h = 12.0;
  growth.age_h = age_h;
  return growth;
}

WindErrorGrowth persisted_wind_error(double climate_sigma_m_s, double memory_h) {
  expects(climate_sigma_m_s >= 0 && memory_h > 0, "a wind varies and remembers");
  WindErrorGrowth growth;
  growth.saturation_m_s = climate_sigma_m_s;
  growth.growth_time_h = 0.5 * memory_h;
  growth.memory_h = memory_h;
  return growth;
}

double climate_sigma_m_s(std::span<const UtcTime> times, std::span<const Horizontal> wind_m_s) {
  expects(times.size() == wind_m_s.size(), "a record has a time for each wind");
  Horizontal sum{};
  double count = 0;
  double first_h = 0;
  double last_h = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!is_finite(wind_m_s[i])) continue;
    last_h = hours_between(times.front(), times[i]);
    if (count == 0) first_h = last_h;
    sum += wind_m_s[i];
    count += 1.0;
  }
  if (count < 2) return wind_climate_sigma_m_s;
  const Horizontal mean = sum / count;
  double squares = 0;
  for (const Horizontal wind : wind_m_s) {
    if (is_finite(wind)) squares += std::norm(wind - mean);
  }
  const double variance = squares / (2.0 * count);
  const double samples = std::min(count, 1.0 + (last_h - first_h) / (2.0 * wind_memory_h));
  const double believed = wind_climate_sigma_m_s * wind_climate_sigma_m_s;
  return std::sqrt((samples * variance + prior_samples * believed) /
                   (samples - 1.0 + prior_samples));
}

std::vector<double> departure_sigma_m_s(std::span<const UtcTime> times, UtcTime end_of_day,
                                        const WindErrorGrowth& growth) {
  std::vector<double> sigma;
  sigma.reserve(times.size());
  for (const UtcTime time : times) {
    const double law = growth.sigma_m_s(hours_between(end_of_day, time));
    sigma.push_back(time < end_of_day ? law : std::hypot(law, extra_sigma_m_s(growth, time)));
  }
  return sigma;
}

std::vector<Horizontal> draw_wind_departures(std::span<const UtcTime> times,
                                             std::span<const double> sigma_m_s, double memory_h,
                                             Rng& random) {
  expects(times.size() == sigma_m_s.size(), "departures need a standard deviation for each time");
  expects(memory_h > 0, "departures of the wind last a positive time");
  std::vector<Horizontal> departures(times.size());
  for (std::size_t k = 0; k < times.size(); ++k) {
    const double sigma = sigma_m_s[k];
    expects(sigma >= 0, "a standard deviation is not negative");
    const double east = random.normal();
    const double north = random.normal();
    double kept = 0;
    double before = 0;
    if (k > 0) {
      expects(times[k] > times[k - 1], "the times of departures ascend");
      before = sigma_m_s[k - 1];
      kept = std::exp(-hours_between(times[k - 1], times[k]) / memory_h);
      if (sigma < before) kept *= sigma / before;
    }
    const double fresh = std::sqrt(std::max(0.0, sigma * sigma - kept * kept * before * before));
    departures[k] = fresh * Horizontal(east, north);
    if (k > 0) departures[k] += kept * departures[k - 1];
  }
  return departures;
}

std::vector<Horizontal> draw_wind_departures(std::span<const UtcTime> times, UtcTime end_of_day,
                                             const WindErrorGrowth& growth, Rng& random) {
  return draw_wind_departures(times, departure_sigma_m_s(times, end_of_day, growth),
                              growth.memory_h, random);
}

}  // namespace slackwater::calibration
