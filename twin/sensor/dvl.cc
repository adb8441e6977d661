#include "twin/sensor/dvl.h"

namespace slackwater::twin {
namespace {

struct Echo {
  std::optional<double> range_m;
  double free_m = 1e9;  ///< how far the beam goes through water
};

Echo echo_of(const Dvl& dvl, const Scene& scene, const Ray& ray) {
  Echo echo;
  const std::optional<Hit> hit = first_hit(scene, ray);
  if (!hit) return echo;
  echo.free_m = hit->range_m;
  const bool heard = hit->range_m >= dvl.nearest_m && hit->range_m <= dvl.farthest_m &&
                     hit->squareness(ray) >= dvl.least_squareness;
  if (heard) echo.range_m = hit->range_m;
  return echo;
}

}  // namespace

std::optional<DvlReading> measured(const Dvl& dvl, NoiseStream& noise, const Scene& scene,
                                   const WaterAt& water, const Triple<double>& at_m,
                                   const Rotation<double>& r, const Triple<double>& velocity_m_s) {
  const JanusBeams beams = janus_beams(dvl.slant_rad, dvl.azimuth_rad, false);
  const double along = std::cos(dvl.slant_rad);
  BeamSpeeds to_bed, to_water;
  double ranges_m = 0;
  int heard = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Ray ray{at_m, r.to_ned(beams[i])};
    const double error_m_s = dvl.noise_sd_m_s * noise.normal();
    const Echo echo = echo_of(dvl, scene, ray);
    if (echo.range_m) {
      to_bed[i] = dvl.scale * dot(velocity_m_s, ray.direction) + error_m_s;
      ranges_m += *echo.range_m;
      ++heard;
    }
    // The layer must lie wholly in the water.
    if (echo.free_m * along < dvl.layer_far_m) continue;
    Triple<double> flow;
    constexpr int samples = 4;
    for (int k = 0; k < samples; ++k) {
      const double share = (k + 0.5) / samples;
      const double down_m = dvl.layer_near_m + share * (dvl.layer_far_m - dvl.layer_near_m);
      flow = flow + (1.0 / samples) * water(at_m + (down_m / along) * ray.direction);
    }
    to_water[i] = dvl.scale * dot(velocity_m_s - flow, ray.direction) + error_m_s;
  }
  DvlReading reading;
  if (heard > 0) reading.altitude_m = along * ranges_m / heard;
  std::optional<JanusVelocity> track = janus_velocity(beams, to_bed);
  reading.bottom = track.has_value();
  reading.water = janus_velocity(beams, to_water);
  if (!track) track = reading.water;
  if (!track) return std::nullopt;
  reading.track = *track;
  return reading;
}

}  // namespace slackwater::twin
