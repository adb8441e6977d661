#include "twin/state/headway.h"

#include <algorithm>
#include <cmath>

namespace slackwater::twin {

HeadwayWatch headway_watch_of(const Mission& mission, const Autopilot& autopilot) {
  HeadwayWatch watch;
  watch.least_gain_m = 0.02 * watch.patience_s * mission.guidance.speed_m_s;
  watch.arrived_m = 3 * std::max(mission.guidance.tolerance_m, mission.guidance.passing_m);
  watch.strayed_m = 3 * std::max(autopilot.settings.holding_radius_m, watch.arrived_m);
  return watch;
}

bool has_lost_headway(const HeadwayWatch& watch, const Reference& reference, const Route& route,
                      const Triple<double>& position_m, double t_s, HeadwayState& state) noexcept {
  if (reference.target == Target::cruise) {
    state.least_at_s = -1;
    return false;
  }
  const bool holds = reference.target == Target::station;
  const Triple<double> target = holds ? reference.position_m : route.to().position_m;
  const Triple<double> left = target - position_m;
  const double away_m = std::sqrt(dot(left, left));
  const Triple<double> other = target - state.target_m;
  const bool is_new = state.least_at_s < 0 || dot(other, other) > 1e-6;
  const double gain_m = holds ? 0.0 : watch.least_gain_m;
  if (is_new || away_m < state.least_m - gain_m) {
    state = {target, away_m, t_s};
    return false;
  }
  const double near_m = holds ? watch.strayed_m : watch.arrived_m;
  return away_m > near_m && away_m > state.least_m && t_s - state.least_at_s > watch.patience_s;
}

}  // namespace slackwater::twin
