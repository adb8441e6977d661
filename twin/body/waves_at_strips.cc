#include "twin/body/waves_at_strips.h"

#include <algorithm>
#include <span>

#include "fields/wave/sea_sampling.h"
#include "twin/body/frame.h"

namespace slackwater::twin {
namespace {

WaveRow row_of(const FloatingHull& hull, const HullPart& part, std::size_t first,
               const Rotation<double>& r, const Triple<double>& position_m, double t_s) {
  const Vector3<Enu> at = enu_of(strip_place(hull, part, first, r, position_m));
  const Vector3<Enu> step = enu_of(r.to_ned({part.strip_length_m, 0, 0}));
  return {{at.x(), at.y(), at.z(), t_s}, step.x(), step.y(), step.z()};
}

}  // namespace

WaterAtStrips<double> waves_at_strips(const SeaRealisation& sea, double t_s,
                                      const FloatingHull& hull, const BodyState<double>& state) {
  const Rotation<double> r = rotation_of(state.attitude);
  std::array<WaveSample, most_strips> samples;
  for (std::size_t p = 0; p < hull.parts; ++p) {
    const HullPart& part = hull.part[p];
    // One that does not say is looked at strip by strip.
    const std::size_t in_row = std::max<std::size_t>(part.strips_in_row, 1);
    for (std::size_t first = part.first; first < part.first + part.strips; first += in_row)
      sample_row(sea, row_of(hull, part, first, r, state.position_m, t_s),
                 std::span(samples).subspan(first, in_row));
  }
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
