#include "twin/control/control_laws.h"

namespace slackwater::twin {
namespace {

double ahead_of(const Course& bow, double north, double east) noexcept {
  return bow.north * north + bow.east * east;
}

/// A velocity over ground is had by pointing along it less the water's, as far as that is known,
/// and less the drift that shows (wind, unknown current). On station that points the bow into the
/// disturbance; what is too little to point at is left to a push ahead or astern.
Way way_over_ground(const Autopilot& a, const Measured& measured, const Triple<double>& wanted_m_s,
                    const Outset& outset, ControlState& state) noexcept {
  const double most = a.settings.most_speed_m_s;
  double north = wanted_m_s.x - measured.water_m_s.x + state.drift_north_m_s;
  double east = wanted_m_s.y - measured.water_m_s.y + state.drift_east_m_s;
  const double size = std::sqrt(north * north + east * east);
  const bool has_course = state.kept_north != 0 || state.kept_east != 0;
  if (size > 0.03 * most) {
    state.kept_north = north / size;
    state.kept_east = east / size;
  } else if (!has_course) {
    state.kept_north = outset.bow.north;
    state.kept_east = outset.bow.east;
  }
  return {{state.kept_north, state.kept_east},
          std::clamp(ahead_of(outset.bow, north, east), -most_astern_share * most, most),
          0};
}

/// Learns the drift while the bow is about where it should be.
void learn_drift(const Autopilot& a, const Triple<double>& wanted_m_s, const Outset& outset,
                 double to_turn, double dt_s, ControlState& state) noexcept {
  if (std::abs(to_turn) > 0.5) return;
  const double rate = 0.35 * a.station_per_s * dt_s;
  const double most = a.settings.most_speed_m_s;
  state.drift_north_m_s = std::clamp(
      state.drift_north_m_s + rate * (wanted_m_s.x - outset.velocity_m_s.x), -most, most);
  state.drift_east_m_s =
      std::clamp(state.drift_east_m_s + rate * (wanted_m_s.y - outset.velocity_m_s.y), -most, most);
}

}  // namespace

Effort steer_by_turning(const Autopilot& a, const Measured& measured, const Reference& reference,
                        const Outset& outset, double dt_s, ControlState& state) noexcept {
  const double most = a.settings.most_speed_m_s;
  const double most_turn = a.settings.most_yaw_rate_rad_s;
  Way way{reference.heading, std::clamp(reference.velocity_m_s.x, -most_astern_share * most, most),
          0};
  Triple<double> over_ground;
  if (reference.target != Target::cruise)
    over_ground = wanted_velocity(a, measured, reference, outset);
  const bool is_station = reference.target == Target::station;
  if (is_station) way = way_over_ground(a, measured, over_ground, outset, state);
  if (reference.target == Target::path)
    way = way_along(a, measured, reference, over_ground, outset, dt_s, state);
  const double to_turn = turn_rad(outset.bow, way.heading);
  const double yaw_rate = std::clamp(a.heading.outer_per_s * to_turn, -most_turn, most_turn);
  const double yaw_lacking = yaw_rate - measured.nu.angular.z;
  const double yaw_push = acceleration_of(a.heading, yaw_lacking, state.yaw_rad_s2);

  const AheadLoop ahead = ahead_loop(a, measured, way, dt_s, state);
  // On station the drift is the integral, and says the course too: a second one would hold the
  // craft on its station with no course to steer.
  const double lacking = is_station ? ahead_of(outset.bow, over_ground.x - outset.velocity_m_s.x,
                                               over_ground.y - outset.velocity_m_s.y)
                                    : ahead.lacking_m_s;
  const double push = acceleration_of(a.horizontal, lacking, is_station ? 0.0 : state.surge_m_s2);

  const double turning_n_m = resistance(a, {{}, {0, 0, yaw_rate}}).angular.z;
  const Spatial<double> tau{{push_ahead_n(a, way, push, state), 0, 0},
                            {0, 0, a.mass.entry[5][5] * yaw_push + turning_n_m}};
  const Thrusts thrusts = allocate(a.allocation, tau);
  integrate(a.heading, yaw_lacking, yaw_push, thrusts.share[5], dt_s, state.yaw_rad_s2);
  if (is_station)
    learn_drift(a, over_ground, outset, to_turn, dt_s, state);
  else
    integrate(a.horizontal, lacking, push, thrusts.share[0], dt_s, state.surge_m_s2);
  Effort effort;
  effort.thrust_n = thrusts.thrust_n;
  return effort;
}

}  // namespace slackwater::twin
