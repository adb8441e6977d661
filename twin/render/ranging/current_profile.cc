#include "twin/render/ranging/current_profile.h"

#include <cmath>
#include <limits>

#include "twin/render/light/counted_noise.h"
#include "twin/sensor/bin_mean.h"

namespace slackwater::twin {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

bool is_known(const Triple<double>& v) { return std::isfinite(v.x + v.y + v.z); }

/// One of the beams: its ray, and how far along the axis it is free of the boundary's side lobe.
struct ProfilerBeam {
  Ray ray;
  double free_to_m = std::numeric_limits<double>::infinity();
};

}  // namespace

const char* name_of(BinFlaw flaw) noexcept {
  constexpr std::array<const char*, 3> names{"none", "side_lobe", "no_water"};
  return names[static_cast<std::size_t>(flaw)];
}

CurrentProfile profiled(const RayCaster& caster, const Adcp& adcp, const WaterAt& water,
                        const Pose& pose, double most_range_m, std::uint64_t seed) {
  const JanusBeams beams = janus_beams(adcp.slant_rad, adcp.azimuth_rad, false);
  const double along = std::cos(adcp.slant_rad);
  const Triple<double> forward = cross(pose.right, pose.axis);
  const auto to_ned = [&](const Triple<double>& b) {
    return b.x * forward + b.y * pose.right + b.z * pose.axis;
  };
  CurrentProfile profile;
  std::array<ProfilerBeam, 4> heard;
  for (std::size_t i = 0; i < heard.size(); ++i) {
    heard[i].ray = {pose.position_m, to_ned(beams[i])};
    profile.beams[i] = heard[i].ray.direction;
    const auto hit = caster.first_hit(heard[i].ray, most_range_m);
    profile.boundary_range_m[i] = static_cast<float>(hit ? hit->range_m : unknown);
    if (hit) heard[i].free_to_m = hit->range_m * along * along;
  }
  const double sd_m_s = adcp.noise_sd_m_s / std::sqrt(static_cast<double>(adcp.pings));
  for (int bin = 0; bin < adcp.bins; ++bin) {
    ProfileBin out;
    out.distance_m = adcp.blanking_m + (bin + 1) * adcp.bin_m;
    const Ray axis{pose.position_m, pose.axis};
    out.depth_m = (axis.from_m + out.distance_m * axis.direction).z;
    out.true_velocity_m_s = bin_mean(adcp, water, axis, out.distance_m, 1);
    out.velocity_m_s = {unknown, unknown, unknown};
    out.error_m_s = unknown;
    BeamSpeeds speeds;
    bool is_dry = false;
    for (std::size_t i = 0; i < heard.size(); ++i) {
      out.approach_m_s[i] = static_cast<float>(unknown);
      if (out.distance_m + adcp.bin_m > heard[i].free_to_m) continue;
      const Triple<double> flow = bin_mean(adcp, water, heard[i].ray, out.distance_m, along);
      is_dry = is_dry || !is_known(flow);
      if (!is_known(flow)) continue;
      const double error_m_s =
          sd_m_s * normal_at(noise_key(seed, i, static_cast<std::uint64_t>(bin)));
      speeds[i] =
          folded(dot(pose.velocity_m_s - flow, heard[i].ray.direction), adcp.ambiguity_m_s) +
          error_m_s;
      out.approach_m_s[i] = static_cast<float>(*speeds[i]);
    }
    if (const auto found = janus_velocity(beams, speeds)) {
      out.velocity_m_s = pose.velocity_m_s - to_ned(found->velocity_m_s);
      if (found->beams == 4) out.error_m_s = found->error_m_s;
    } else {
      out.flaw = is_dry ? BinFlaw::no_water : BinFlaw::side_lobe;
    }
    profile.bins.push_back(out);
  }
  return profile;
}

}  // namespace slackwater::twin
