#include "twin/search/datum.h"

namespace slackwater::twin {

Triple<double> expected_drift(const LeewayObject& object, const Triple<double>& current_m_s,
                              const Triple<double>& wind_10m_m_s) noexcept {
  const LeewayDraw mean = mean_leeway(object);
  const Triple<double> through = 0.5 * (leeway_velocity(mean, true, wind_10m_m_s) +
                                        leeway_velocity(mean, false, wind_10m_m_s));
  return {current_m_s.x + through.x, current_m_s.y + through.y, 0};
}

void turn_datum(const Triple<double>& velocity_m_s, double t_s, DatumState& state) noexcept {
  state.drifted_m = state.drifted_at(t_s);
  state.velocity_m_s = velocity_m_s;
  state.at_s = t_s;
}

}  // namespace slackwater::twin
