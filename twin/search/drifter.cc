#include "twin/search/drifter.h"

#include <cmath>

namespace slackwater::twin {

DrifterState begin_drift(const Triple<double>& last_known_m, double radius_m, Rng rng) noexcept {
  DrifterState state;
  // The circle of a normal on two axes that holds one half: r = s sqrt(2 log 2).
  const double std_m = radius_m / std::sqrt(2 * std::log(2.0));
  state.position_m.x = last_known_m.x + std_m * rng.normal();
  state.position_m.y = last_known_m.y + std_m * rng.normal();
  state.is_left = rng.uniform() < 0.5;
  state.rng = rng;
  return state;
}

void drift(const Drifter& drifter, const Triple<double>& current_m_s,
           const Triple<double>& wind_10m_m_s, double dt_s, DrifterState& state) noexcept {
  const Triple<double> through = leeway_velocity(drifter.leeway, state.is_left, wind_10m_m_s);
  const double walk_m = std::sqrt(2 * drifter.diffusivity_m2_s * dt_s);
  state.position_m.x += (current_m_s.x + through.x) * dt_s + walk_m * state.rng.normal();
  state.position_m.y += (current_m_s.y + through.y) * dt_s + walk_m * state.rng.normal();
  if (state.rng.uniform() < -std::expm1(-drifter.jibe_rate_per_s * dt_s))
    state.is_left = !state.is_left;
}

}  // namespace slackwater::twin
