#include "twin/sensor/adcp.h"

#include "twin/sensor/bin_mean.h"

namespace slackwater::twin {

Triple<double> bin_mean(const Adcp& adcp, const WaterAt& water, const Ray& ray, double centre_m,
                        double along) {
  constexpr int half = 4;
  Triple<double> sum;
  for (int k = 1 - half; k < half; ++k) {
    const double place = static_cast<double>(k) / half;
    const double weight = (1 - std::abs(place)) / half;
    const double range_m = (centre_m + place * adcp.bin_m) / along;
    sum = sum + weight * water(ray.from_m + range_m * ray.direction);
  }
  return sum;
}

double folded(double speed_m_s, double ambiguity_m_s) noexcept {
  const double span = 2 * ambiguity_m_s;
  return speed_m_s - span * std::floor((speed_m_s + ambiguity_m_s) / span);
}

std::vector<AdcpBin> measured(const Adcp& adcp, NoiseStream& noise, const Scene& scene,
                              const WaterAt& water, const Triple<double>& at_m,
                              const Rotation<double>& r, const Triple<double>& velocity_m_s) {
  const JanusBeams beams = janus_beams(adcp.slant_rad, adcp.azimuth_rad, adcp.looks_up);
  const double along = std::cos(adcp.slant_rad);
  std::array<double, 4> reach_m{};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::optional<Hit> hit = first_hit(scene, Ray{at_m, r.to_ned(beams[i])});
    // Side lobes hear the boundary at its nearest, which is nearer than along the slanted beam by
    // its cosine.
    reach_m[i] = hit ? hit->range_m * along * along : 1e9;
  }
  const double sd_m_s = adcp.noise_sd_m_s / std::sqrt(static_cast<double>(adcp.pings));
  const double look = adcp.looks_up ? -1 : 1;
  std::vector<AdcpBin> profile;
  for (int bin = 0; bin < adcp.bins; ++bin) {
    const double centre_m = adcp.blanking_m + (bin + 1) * adcp.bin_m;
    AdcpBin out;
    out.down_m = (at_m + r.to_ned({0, 0, look * centre_m})).z;
    BeamSpeeds speeds;
    for (std::size_t i = 0; i < 4; ++i) {
      const double error_m_s = sd_m_s * noise.normal();
      if (centre_m + adcp.bin_m > reach_m[i]) continue;
      const Ray ray{at_m, r.to_ned(beams[i])};
      const Triple<double> flow = bin_mean(adcp, water, ray, centre_m, along);
      speeds[i] = folded(dot(velocity_m_s - flow, ray.direction), adcp.ambiguity_m_s) + error_m_s;
    }
    if (const auto found = janus_velocity(beams, speeds)) {
      out.velocity_m_s = velocity_m_s - r.to_ned(found->velocity_m_s);
      out.error_m_s = found->error_m_s;
    }
    profile.push_back(out);
  }
  return profile;
}

}  // namespace slackwater::twin
