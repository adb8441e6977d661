#include "calibration/skill/slab_response.h"

#include <cmath>
#include <complex>

#include "fields/base/constants.h"

namespace slackwater::calibration {

Horizontal reference_stress_pa(Horizontal wind_m_s) noexcept {
  const double speed = std::abs(wind_m_s);
  const double drag = speed < 20.5 ? (0.79 + 0.08 * speed) * 1e-3 : 2.43e-3;
  return constants::air_density_kg_m3 * drag * speed * wind_m_s;
}

std::vector<Horizontal> slab_response(std::span<const Horizontal> stress_pa, const Slab& slab) {
  std::vector<Horizontal> response(stress_pa.size());
  const Horizontal turn = std::exp(-Horizontal(slab.damping_per_h, slab.coriolis_rad_h));
  const double per_pa = 3600.0 / (slab.density_kg_m3 * slab.depth_m);
  for (std::size_t i = 1; i < response.size(); ++i)
    response[i] = turn * response[i - 1] + 0.5 * per_pa * (stress_pa[i - 1] + stress_pa[i]);
  return response;
}

}  // namespace slackwater::calibration
