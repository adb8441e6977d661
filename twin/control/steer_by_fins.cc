#include "twin/control/control_laws.h"

namespace slackwater::twin {
namespace {

/// Seconds in which the moving mass takes over what the elevator holds.
constexpr double trim_time_s = 60;

/// Round the place to be held, clockwise: the further off, the straighter towards it.
Way circling(const Autopilot& a, const Measured& measured, const Reference& reference,
             const Outset& outset, const ControlState& state) noexcept {
  const double radius = a.settings.holding_radius_m;
  const double speed = std::max(a.settings.least_speed_m_s, 0.6 * a.settings.most_speed_m_s);
  const double north = measured.position_m.x - reference.position_m.x;
  const double east = measured.position_m.y - reference.position_m.y;
  const double away = std::sqrt(north * north + east * east);
  if (away < 1e-3) return {outset.bow, speed, 0};
  const double outward_n = north / away, outward_e = east / away;
  const double inward = std::clamp(2 * (away - radius) / radius, -3.0, 10.0);
  const double length = std::sqrt(1 + inward * inward);
  const Course course{(-outward_e - inward * outward_n) / length,
                      (outward_n - inward * outward_e) / length};
  const Triple<double> drift{measured.water_m_s.x - state.drift_north_m_s,
                             measured.water_m_s.y - state.drift_east_m_s, 0};
  return {crabbing(course, speed, drift), speed, std::abs(inward) < 1 ? speed / radius : 0.0};
}

Way way_of(const Autopilot& a, const Measured& measured, const Reference& reference,
           const Triple<double>& wanted_m_s, const Outset& outset, double dt_s,
           ControlState& state) noexcept {
  switch (reference.target) {
    case Target::station:
      return circling(a, measured, reference, outset, state);
    case Target::path:
      return way_along(a, measured, reference, wanted_m_s, outset, dt_s, state);
    case Target::cruise:
      break;
  }
  return {reference.heading, std::clamp(reference.velocity_m_s.x, 0.0, a.settings.most_speed_m_s),
          0};
}

/// Dives and climbs by pitching, the elevator at first and the moving mass in the long run.
/// @return the elevator
double pitch_to(const Autopilot& a, const Measured& measured, const Outset& outset, double down_m_s,
                double ahead_m_s, double elevator_n_m, double dt_s, ControlState& state) noexcept {
  const double way = std::max(ahead_m_s, a.settings.least_speed_m_s);
  const double most_sine = std::min(a.tan_most_tilt, 0.9);
  const double asked = -(down_m_s + state.dive_m_s) / way;
  const double sine = std::clamp(asked, -most_sine, most_sine);
  const double pitch_rate = a.tilt.outer_per_s * (sine + outset.r.down.x);
  const double lacking = pitch_rate - measured.nu.angular.y;
  const double push = acceleration_of(a.tilt, lacking, state.pitch_rad_s2);
  const double moment = a.mass.entry[4][4] * push + a.righting_n_m * sine +
                        a.quadratic_damping.angular.y * std::abs(pitch_rate) * pitch_rate;
  const double most_trim = a.trim.moving_mass_kg * constants::gravity_m_s2 * a.trim.travel_m;
  const double elevator = (moment - state.trim_n_m) / elevator_n_m;
  const double bounded = std::clamp(elevator, -a.elevator.limit_rad, a.elevator.limit_rad);
  integrate(a.tilt, lacking, push, elevator == bounded ? 1.0 : 0.0, dt_s, state.pitch_rad_s2);
  state.trim_n_m = std::clamp(state.trim_n_m + dt_s / trim_time_s * (moment - state.trim_n_m),
                              -most_trim, most_trim);
  if (sine == asked && ahead_m_s > 0.8 * a.settings.least_speed_m_s) {
    const double most_dive = 0.3 * a.settings.most_speed_m_s;
    state.dive_m_s = std::clamp(
        state.dive_m_s + dt_s * 0.5 * a.vertical.outer_per_s * (down_m_s - outset.velocity_m_s.z),
        -most_dive, most_dive);
  }
  return bounded;
}

/// Without way on: the buoyancy engine, at a quarter of the pace.
void sink_by_volume(const Autopilot& a, const Outset& outset, double dt_s,
                    ControlState& state) noexcept {
  constexpr double slower = 0.25;
  const double outer = slower * a.vertical.outer_per_s;
  const double most = a.settings.most_descent_m_s;
  const double down = std::clamp(outer * outset.too_shallow_m, -most, most);
  const double lacking = down - outset.velocity_m_s.z;
  const double push = slower * a.vertical.inner_per_s * lacking + state.down_m_s2;
  const double volume = -a.mass.entry[2][2] * push / a.displacement_n_m3;
  state.volume_m3 = std::clamp(volume, a.trim.least_volume_m3, a.trim.most_volume_m3);
  if (state.volume_m3 == volume)
    state.down_m_s2 += dt_s * slower * slower * a.vertical.integral_per_s2 * lacking;
}

}  // namespace

Effort steer_by_fins(const Autopilot& a, const Measured& measured, const Reference& reference,
                     const Outset& outset, double dt_s, ControlState& state) noexcept {
  const AutopilotSettings& s = a.settings;
  const Triple<double> wanted = wanted_velocity(a, measured, reference, outset);
  const Way way = way_of(a, measured, reference, wanted, outset, dt_s, state);
  const AheadLoop ahead = ahead_loop(a, measured, way, dt_s, state);
  const double steering = std::max(ahead.through_m_s, s.least_speed_m_s);
  const double rudder_n_m = a.rudder_n_m_s2_m2 * steering * steering;
  const double elevator_n_m = a.elevator_n_m_s2_m2 * steering * steering;
  const double push = acceleration_of(a.horizontal, ahead.lacking_m_s, state.surge_m_s2);
  const Thrusts thrusts = allocate(a.allocation, {{push_ahead_n(a, way, push, state), 0, 0}, {}});
  integrate(a.horizontal, ahead.lacking_m_s, push, thrusts.share[0], dt_s, state.surge_m_s2);

  const double yaw_rate =
      std::clamp(a.heading.outer_per_s * turn_rad(outset.bow, way.heading) + way.yaw_rate_rad_s,
                 -s.most_yaw_rate_rad_s, s.most_yaw_rate_rad_s);
  const double yaw_lacking = yaw_rate - measured.nu.angular.z;
  const double yaw_push = acceleration_of(a.heading, yaw_lacking, state.yaw_rad_s2);
  const double rudder = (a.mass.entry[5][5] * yaw_push +
                         a.quadratic_damping.angular.z * std::abs(yaw_rate) * yaw_rate) /
                        rudder_n_m;

  Effort effort;
  effort.thrust_n = thrusts.thrust_n;
  effort.rudder_rad = std::clamp(rudder, -a.rudder.limit_rad, a.rudder.limit_rad);
  integrate(a.heading, yaw_lacking, yaw_push, rudder == effort.rudder_rad ? 1.0 : 0.0, dt_s,
            state.yaw_rad_s2);
  effort.elevator_rad =
      pitch_to(a, measured, outset, wanted.z, ahead.through_m_s, elevator_n_m, dt_s, state);
  if (a.trim.moving_mass_kg > 0)  // forward of its middle it puts the bow down
    effort.moving_mass_m = -state.trim_n_m / (a.trim.moving_mass_kg * constants::gravity_m_s2);
  if (way.ahead_m_s < s.least_speed_m_s && !way.is_over_ground)
    sink_by_volume(a, outset, dt_s, state);
  effort.volume_m3 = state.volume_m3;
  return effort;
}

}  // namespace slackwater::twin
