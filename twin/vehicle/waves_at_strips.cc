#include "twin/vehicle/waves_at_strips.h"

#include <span>

#include "fields/wave/sea_sampling.h"

namespace slackwater::twin {
namespace {

Triple<double> ned_of(const double (&enu)[3]) { return {enu[1], enu[0], -enu[2]}; }

}  // namespace

WaterAtStrips<double> waves_at_strips(const SeaRealisation& sea, double t_s,
                                      const FloatingHull& hull, const BodyState<double>& state) {
  const Rotation<double> r = rotation_of(state.attitude);
  std::array<WavePlace, most_strips> places{};
  for (std::size_t i = 0; i < hull.strips; ++i) {
    const Triple<double> at = strip_place(hull, i, r, state.position_m);
    places[i] = {at.y, at.x, -at.z, t_s};
  }
  std::array<WaveSample, most_strips> samples{};
  sample_waves(sea, std::span(places).first(hull.strips), std::span(samples).first(hull.strips));
  WaterAtStrips<double> water;
  for (std::size_t i = 0; i < hull.strips; ++i) {
    const WaveSample& sample = samples[i];
    if (!has_value(sample.motion.status)) {
      water.head_m[i] = sample.motion.elevation_m;
      continue;
    }
    water.head_m[i] =
        sample.pressure_pa / (constants::sea_water_density_kg_m3 * constants::gravity_m_s2);
    water.velocity_m_s[i] = ned_of(sample.motion.velocity_m_s);
    water.acceleration_m_s2[i] = ned_of(sample.acceleration_m_s2);
  }
  return water;
}

}  // namespace slackwater::twin
