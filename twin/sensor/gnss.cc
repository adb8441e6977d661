#include "twin/sensor/gnss.h"

namespace slackwater::twin {

GnssState started(const Gnss& gnss, const NoiseStream& noise) noexcept {
  GnssState state;
  state.noise = noise;
  const Triple<double> n = state.noise.normals();
  state.slow_m = {gnss.slow_horizontal_m.sd * n.x, gnss.slow_horizontal_m.sd * n.y,
                  gnss.slow_vertical_m.sd * n.z};
  state.seen_s = gnss.reacquisition_s;
  return state;
}

std::optional<GnssFix> measured(const Gnss& gnss, GnssState& state, const Triple<double>& antenna_m,
                                const Triple<double>& velocity_m_s, double surface_m,
                                double dt_s) noexcept {
  // The sky's error goes on whether it is seen or not.
  state.slow_m.x = later(gnss.slow_horizontal_m, state.slow_m.x, dt_s, state.noise);
  state.slow_m.y = later(gnss.slow_horizontal_m, state.slow_m.y, dt_s, state.noise);
  state.slow_m.z = later(gnss.slow_vertical_m, state.slow_m.z, dt_s, state.noise);
  const Triple<double> white = state.noise.normals();
  const Triple<double> doppler = state.noise.normals();
  state.seen_s = antenna_m.z < surface_m ? state.seen_s + dt_s : 0;
  if (antenna_m.z >= surface_m || state.seen_s < gnss.reacquisition_s) return std::nullopt;
  return GnssFix{
      antenna_m + state.slow_m +
          Triple<double>{gnss.white_horizontal_sd_m * white.x, gnss.white_horizontal_sd_m * white.y,
                         gnss.white_vertical_sd_m * white.z},
      velocity_m_s + gnss.velocity_sd_m_s * doppler};
}

}  // namespace slackwater::twin
