#include "twin/control/control_laws.h"

namespace slackwater::twin {
namespace {

/// What the added mass does to a craft that is not bow on to its flow (Munk's moment): it turns it
/// further across, faster than a light ROV's righting moment turns it back from some 0.3 m/s on.
/// Taken beforehand, as the flow will be when the thrusters have followed; C_A(nu) nu of a diagonal
/// M_A, Fossen (2011) 6.42.
Triple<double> turning_of_flow(const Autopilot& a, const Spatial<double>& nu) noexcept {
  const Triple<double>& m = a.added_mass;
  const Triple<double>& w = nu.angular;
  const double u = nu.linear.x;
  const double v = nu.linear.y - a.lag_s * (w.z * u - w.x * nu.linear.z);
  const double heave = nu.linear.z + a.lag_s * (w.y * u - w.x * nu.linear.y);
  return {(m.z - m.y) * v * heave, (m.x - m.z) * u * heave, (m.y - m.x) * u * v};
}

/// At speed that moment asks for quick small pushes either way, which thrusters with a dead band
/// give only off it: those that pitch the craft then push against each other a little, which makes
/// no wrench.
void lift_off_dead_band(const Autopilot& a, double ahead_m_s, Thrusts& thrusts) noexcept {
  constexpr double share_of_range = 0.06;
  const double upsetting_n_m = (a.added_mass.z - a.added_mass.x) * ahead_m_s * ahead_m_s;
  // None up to four times the righting moment, all of it from nine times on.
  const double need = upsetting_n_m - 4 * a.righting_n_m;
  if (!(need > 0) || !a.allocation.has_idle) return;
  std::size_t pitching = 0;
  const auto& effect = a.allocation.effect[static_cast<std::size_t>(Axis::pitch)];
  for (std::size_t i = 1; i < a.allocation.mounts; ++i)
    if (std::abs(effect[i]) > std::abs(effect[pitching])) pitching = i;
  const auto& idle = a.allocation.idle[pitching];
  if (!(idle[pitching] > 1e-6)) return;
  const double size = std::min(need, 5 * a.righting_n_m) / std::max(5 * a.righting_n_m, 1e-9) *
                      share_of_range * a.allocation.most_n[pitching] / idle[pitching];
  for (std::size_t i = 0; i < a.allocation.mounts; ++i)
    thrusts.thrust_n[i] = std::clamp(thrusts.thrust_n[i] + size * idle[i], a.allocation.least_n[i],
                                     a.allocation.most_n[i]);
}

}  // namespace

Effort steer_free(const Autopilot& a, const Measured& measured, const Reference& reference,
                  const Outset& outset, double dt_s, ControlState& state) noexcept {
  const Rotation<double>& r = outset.r;
  const Spatial<double>& nu = measured.nu;
  const Triple<double> wanted =
      eased_velocity(a, wanted_velocity(a, measured, reference, outset), dt_s, state);
  const Triple<double> lacking = wanted - outset.velocity_m_s;
  const double most_turn = a.settings.most_yaw_rate_rad_s;
  const double yaw_rate = std::clamp(
      a.heading.outer_per_s * turn_rad(outset.bow, reference.heading), -most_turn, most_turn);
  const double yaw_lacking = yaw_rate - nu.angular.z;

  const Triple<double> push_ned{acceleration_of(a.horizontal, lacking.x, state.north_m_s2),
                                acceleration_of(a.horizontal, lacking.y, state.east_m_s2),
                                acceleration_of(a.vertical, lacking.z, state.down_m_s2)};
  Spatial<double> acceleration{r.to_body(push_ned), {}};
  if (!a.allocation.commands(Axis::heave)) acceleration.linear.z = 0;
  if (a.allocation.commands(Axis::roll))
    acceleration.angular.x = a.tilt.inner_per_s * (-a.tilt.outer_per_s * r.down.y - nu.angular.x);
  if (a.allocation.commands(Axis::pitch))
    acceleration.angular.y = a.tilt.inner_per_s * (a.tilt.outer_per_s * r.down.x - nu.angular.y);
  acceleration.angular.z = acceleration_of(a.heading, yaw_lacking, state.yaw_rad_s2);

  // The drag of the velocity that is asked for, in still water or in the current that is known.
  Triple<double> through = wanted - reference.carried_m_s;
  Spatial<double> nu_r = nu;
  nu_r.linear = nu.linear - r.to_body(reference.carried_m_s);
  if (a.settings.current_feed_forward) {
    through = wanted - measured.water_m_s;
    nu_r.linear = nu.linear - r.to_body(measured.water_m_s);
  }
  Spatial<double> tau = a.mass * acceleration;
  tau = tau + resistance(a, {r.to_body(through), {0, 0, yaw_rate}});
  tau.angular = tau.angular + turning_of_flow(a, nu_r);
  Thrusts thrusts = allocate(a.allocation, tau);
  if (a.allocation.commands(Axis::pitch)) lift_off_dead_band(a, nu_r.linear.x, thrusts);

  integrate(a.horizontal, lacking.x, push_ned.x, thrusts.share[0], dt_s, state.north_m_s2);
  integrate(a.horizontal, lacking.y, push_ned.y, thrusts.share[0], dt_s, state.east_m_s2);
  integrate(a.vertical, lacking.z, push_ned.z, thrusts.share[2], dt_s, state.down_m_s2);
  integrate(a.heading, yaw_lacking, acceleration.angular.z, thrusts.share[5], dt_s,
            state.yaw_rad_s2);
  Effort effort;
  effort.thrust_n = thrusts.thrust_n;
  return effort;
}

}  // namespace slackwater::twin
