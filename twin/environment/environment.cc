#include "twin/environment/environment.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fields/base/check.h"
#include "fields/wave/sea_sampling.h"
#include "twin/body/frame.h"

namespace slackwater::twin {
namespace {

using constants::degree;

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
  for (const CurrentSample& sample : current) {
    out.status = sample.status;
    if (!has_value(out.status)) return out;
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
  if (!environment_->sea || !has_value(out.status)) return out;
  const Vector3<Enu> at = enu_of(position_m);
  const WaveSample wave = sample_waves(*environment_->sea, {at.x(), at.y(), at.z(), t_s});
  out.motion.elevation_m = wave.motion.elevation_m;
  if (has_value(wave.motion.status)) {
    out.motion.velocity_m_s = out.motion.velocity_m_s + ned_of(wave.motion.velocity_m_s);
    out.motion.acceleration_m_s2 = ned_of(wave.acceleration_m_s2);
  } else if (wave.motion.status != SampleStatus::above_surface) {
    out.status = wave.motion.status;
  }
  return out;
}

EnvironmentSampler::Wind EnvironmentSampler::wind(const Triple<double>& position_m,
                                                  double t_s) const noexcept {
  Wind out;
  const double height_m = std::clamp(height_of(position_m), lowest_wind_m, highest_wind_m);
  const Place at = place(position_m, height_m, t_s);
  WindSample sample;
  environment_->field->sample_wind({&at, 1}, {&sample, 1}, environment_->member);
  out.status = sample.status;
  if (!has_value(out.status)) return out;
  if (environment_->farm)
    out.ratio = environment_->farm->speed_ratio(horizontal_of(position_m), height_m);
  out.velocity_m_s = ned_of(out.ratio * sample.velocity_m_s);
  return out;
}

double EnvironmentSampler::gust_ratio(const Triple<double>& position_m) const noexcept {
  const FarmFlow* farm = environment_->farm.get();
  if (farm == nullptr || !(farm->free_turbulence_intensity() > 0)) return 1;
  return farm->turbulence_intensity(horizontal_of(position_m), height_of(position_m)) /
         farm->free_turbulence_intensity();
}

CurrentSample EnvironmentSampler::forecast_current(const Triple<double>& position_m,
                                                   double t_s) const noexcept {
  return environment_->field->current(place(position_m, std::max(position_m.z, 0.0), t_s),
                                      environment_->member);
}

SeaSample EnvironmentSampler::sea(const Triple<double>& position_m, double t_s) const noexcept {
  if (environment_->stated_sea) return {*environment_->stated_sea, SampleStatus::ok};
  const Place at = place(position_m, 0, t_s);
  SeaSample sample;
  environment_->field->sample_sea({&at, 1}, {&sample, 1});
  if (environment_->waves) {
    double& height_m = sample.sea.significant_height_m;
    height_m = environment_->waves->height_m(environment_->member, height_m, at.time);
  }
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
