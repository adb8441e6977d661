#include "twin/environment/environment.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fields/base/check.h"
#include "fields/wave/sea_sampling.h"
#include "fields/wind/log_profile.h"
#include "twin/body/frame.h"

namespace slackwater::twin {
namespace {

using constants::degree;

constexpr double wind_reference_m = 10;
constexpr double least_gusty_m_s = 0.5;

}  // namespace

DegreesPerMetre degrees_per_metre(const GeoPoint& origin) noexcept {
  // Radii of curvature of the WGS 84 ellipsoid, across and along the meridian.
  constexpr double equatorial_radius_m = 6378137.0;
  constexpr double eccentricity2 = 0.00669437999014;
  const double sine = std::sin(origin.latitude_deg() * degree);
  const double w2 = 1 - eccentricity2 * sine * sine;
  const double across_m = equatorial_radius_m / std::sqrt(w2);
  const double along_m = across_m * (1 - eccentricity2) / w2;
  const double cosine = std::max(std::cos(origin.latitude_deg() * degree), 1e-6);
  return {1 / (across_m * cosine * degree), 1 / (along_m * degree)};
}

EnvironmentSampler::EnvironmentSampler(const Environment& environment)
    : environment_(&environment), per_m_(degrees_per_metre(environment.origin)) {
  expects(environment.field != nullptr, "an environment has a field");
}

Place EnvironmentSampler::place(const Triple<double>& position_m, double vertical_m,
                                double t_s) const noexcept {
  // A position that is no number, or a runaway's, is asked nowhere: outside.
  const double ms = std::clamp(t_s * 1000, -1e14, 1e14);
  return {environment_->origin.longitude_deg() + position_m.y * per_m_.east,
          environment_->origin.latitude_deg() + position_m.x * per_m_.north, vertical_m,
          environment_->epoch + Duration(static_cast<Duration::rep>(std::nearbyint(ms)))};
}

WaterSample EnvironmentSampler::current(const Triple<double>& position_m, double height_m,
                                        double t_s) const noexcept {
  WaterSample out;
  const double upper_m = std::max(position_m.z - 0.5 * height_m, 0.0);
  const double lower_m = std::max(position_m.z + 0.5 * height_m, upper_m);
  const Place at = place(position_m, upper_m, t_s);
  const std::array depths{upper_m, lower_m};
  std::array<CurrentSample, 2> current;
  environment_->field->sample_profile(at.longitude_deg, at.latitude_deg, at.time, depths, current,
                                      environment_->member);
  for (CurrentSample& sample : current) {
    out.status = sample.status;
    if (!has_value(out.status)) return out;
    sample.velocity_m_s = led_current(sample.velocity_m_s, t_s);
  }
  Horizontal velocity = 0.5 * (current[0].velocity_m_s + current[1].velocity_m_s);
  for (const StandingPile& standing : environment_->piles) {
    if (position_m.z < standing.top_m || position_m.z > standing.bottom_m) continue;
    const auto around =
        flow_around_pile(standing.pile, velocity, horizontal_of(position_m) - standing.axis_m);
    if (!around) {
      out.status = SampleStatus::land;
      return out;
    }
    velocity = *around;
  }
  out.current_m_s = ned_of(velocity);
  out.motion.velocity_m_s = out.current_m_s;
  if (lower_m > upper_m) {
    out.motion.shear_per_s =
        ned_of((current[1].velocity_m_s - current[0].velocity_m_s) / (lower_m - upper_m));
  }
  return out;
}

WaterSample EnvironmentSampler::water(const Triple<double>& position_m, double height_m,
                                      double t_s) const noexcept {
  WaterSample out = current(position_m, height_m, t_s);
  const SeaRealisation* sea = waves();
  if (sea == nullptr || !has_value(out.status)) return out;
  const Vector3<Enu> at = enu_of(position_m);
  const WaveSample wave = sample_waves(*sea, {at.x(), at.y(), at.z(), t_s});
  out.motion.elevation_m = wave.motion.elevation_m;
  if (has_value(wave.motion.status)) {
    out.motion.velocity_m_s = out.motion.velocity_m_s + ned_of(wave.motion.velocity_m_s);
    out.motion.acceleration_m_s2 = ned_of(wave.acceleration_m_s2);
  } else if (wave.motion.status != SampleStatus::above_surface) {
    out.status = wave.motion.status;
  }
  return out;
}

EnvironmentSampler::Wind EnvironmentSampler::free_wind(const Triple<double>& position_m,
                                                       double t_s) const noexcept {
  Wind out;
  const double height_m = std::clamp(height_of(position_m), lowest_wind_m, highest_wind_m);
  const Place at = place(position_m, height_m, t_s);
  WindSample sample;
  environment_->field->sample_wind({&at, 1}, {&sample, 1}, environment_->member);
  out.status = sample.status;
  if (!has_value(out.status)) return out;
  if (const WeatherNow* now = led()) {
    const Lead<Horizontal>::Share share = now->wind_10m_m_s.at(t_s);
    sample.velocity_m_s =
        share.own * sample.velocity_m_s + log_profile_ratio(height_m, wind_reference_m) * share.set;
  }
  out.velocity_m_s = ned_of(sample.velocity_m_s);
  return out;
}

EnvironmentSampler::Wind EnvironmentSampler::wind(const Triple<double>& position_m,
                                                  double t_s) const noexcept {
  Wind out = free_wind(position_m, t_s);
  const FarmFlow* flow = farm();
  if (flow == nullptr || !has_value(out.status)) return out;
  const double height_m = std::clamp(height_of(position_m), lowest_wind_m, highest_wind_m);
  out.ratio = flow->speed_ratio(horizontal_of(position_m), height_m);
  out.velocity_m_s = out.ratio * out.velocity_m_s;
  return out;
}

double EnvironmentSampler::gust_ratio(const Triple<double>& position_m, double t_s) const noexcept {
  double ratio = 1;
  if (const WeatherNow* now = led(); now != nullptr && !now->wind_10m_m_s.is_none()) {
    const Place at = place(position_m, wind_reference_m, t_s);
    WindSample own;
    environment_->field->sample_wind({&at, 1}, {&own, 1}, environment_->member);
    const double own_m_s = std::abs(own.velocity_m_s);
    if (has_value(own.status) && own_m_s > least_gusty_m_s)
      ratio = std::abs(now->wind_10m_m_s.of(own.velocity_m_s, t_s)) / own_m_s;
  }
  const FarmFlow* flow = farm();
  if (flow == nullptr || !(flow->free_turbulence_intensity() > 0)) return ratio;
  return ratio * flow->turbulence_intensity(horizontal_of(position_m), height_of(position_m)) /
         flow->free_turbulence_intensity();
}

const WeatherNow* EnvironmentSampler::led() const noexcept {
  return environment_->weather ? environment_->weather->now() : nullptr;
}

Horizontal EnvironmentSampler::led_current(Horizontal forecast_m_s, double t_s) const noexcept {
  const WeatherNow* now = led();
  return now == nullptr ? forecast_m_s : now->current_m_s.of(forecast_m_s, t_s);
}

const FarmFlow* EnvironmentSampler::farm() const noexcept {
  const WeatherNow* now = led();
  return now != nullptr && now->farm ? now->farm.get() : environment_->farm.get();
}

const SeaRealisation* EnvironmentSampler::waves() const noexcept {
  const WeatherNow* now = led();
  return now != nullptr && now->sea ? now->sea.get() : environment_->sea.get();
}

std::optional<double> EnvironmentSampler::visibility_m() const noexcept {
  const WeatherNow* now = led();
  return now == nullptr ? std::nullopt : now->asked.visibility_m;
}

std::optional<double> EnvironmentSampler::water_visibility_m() const noexcept {
  const WeatherNow* now = led();
  return now == nullptr ? std::nullopt : now->asked.water_visibility_m;
}

CurrentSample EnvironmentSampler::forecast_current(const Triple<double>& position_m,
                                                   double t_s) const noexcept {
  CurrentSample sample = environment_->field->current(
      place(position_m, std::max(position_m.z, 0.0), t_s), environment_->member);
  if (has_value(sample.status)) sample.velocity_m_s = led_current(sample.velocity_m_s, t_s);
  return sample;
}

SeaSample EnvironmentSampler::sea(const Triple<double>& position_m, double t_s) const noexcept {
  SeaSample sample;
  double& height_m = sample.sea.significant_height_m;
  if (environment_->stated_sea) {
    sample = {*environment_->stated_sea, SampleStatus::ok};
  } else {
    const Place at = place(position_m, 0, t_s);
    environment_->field->sample_sea({&at, 1}, {&sample, 1});
    if (environment_->waves)
      height_m = environment_->waves->height_m(environment_->member, height_m, at.time);
  }
  // Of a sea that nobody knows there is nothing to lead.
  if (const WeatherNow* now = led(); now != nullptr && std::isfinite(height_m))
    height_m = now->significant_wave_height_m.of(height_m, t_s);
  return sample;
}

SeaLevelSample EnvironmentSampler::sea_level(const Triple<double>& position_m,
                                             double t_s) const noexcept {
  const Place at = place(position_m, 0, t_s);
  SeaLevelSample sample;
  environment_->field->sample_sea_level({&at, 1}, {&sample, 1}, environment_->member);
  return sample;
}

BedSample EnvironmentSampler::bed(const Triple<double>& position_m) const noexcept {
  const Place at = place(position_m, 0, 0);
  BedSample sample;
  environment_->field->sample_bed({&at, 1}, {&sample, 1});
  return sample;
}

std::shared_ptr<const EnvironmentSampler> sampler_of(
    const std::shared_ptr<const Environment>& environment) {
  struct Kept {
    std::shared_ptr<const Environment> environment;
    EnvironmentSampler sampler;
  };
  const auto kept =
      std::make_shared<const Kept>(Kept{environment, EnvironmentSampler(*environment)});
  return {kept, &kept->sampler};
}

}  // namespace slackwater::twin
