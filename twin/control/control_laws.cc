#include "twin/control/control_laws.h"

namespace slackwater::twin {

Triple<double> eased_velocity(const Autopilot& autopilot, const Triple<double>& wanted_m_s,
                              double dt_s, ControlState& state) noexcept {
  const double most = autopilot.settings.most_acceleration_m_s2 * dt_s;
  const double north = wanted_m_s.x - state.wanted_north_m_s;
  const double east = wanted_m_s.y - state.wanted_east_m_s;
  const double size = std::sqrt(north * north + east * east);
  const double share = size > most ? most / size : 1.0;
  state.wanted_north_m_s += share * north;
  state.wanted_east_m_s += share * east;
  state.wanted_down_m_s += std::clamp(wanted_m_s.z - state.wanted_down_m_s, -most, most);
  return {state.wanted_north_m_s, state.wanted_east_m_s, state.wanted_down_m_s};
}

Triple<double> wanted_velocity(const Autopilot& autopilot, const Measured& measured,
                               const Reference& reference, const Outset& outset) noexcept {
  const AutopilotSettings& settings = autopilot.settings;
  Triple<double> wanted{0, 0, reference.velocity_m_s.z};
  if (reference.target == Target::cruise) {
    const Course& ahead = reference.heading;
    const Triple<double>& v = reference.velocity_m_s;
    wanted.x = ahead.north * v.x - ahead.east * v.y;
    wanted.y = ahead.east * v.x + ahead.north * v.y;
  } else {
    const double north = reference.position_m.x - measured.position_m.x;
    const double east = reference.position_m.y - measured.position_m.y;
    const double away = std::sqrt(north * north + east * east);
    // Half of the acceleration brakes; the other half is for what pushes.
    const double speed = approach_speed(autopilot.station_per_s, away, settings.most_speed_m_s,
                                        0.5 * settings.most_acceleration_m_s2);
    const double share = away > 0 ? speed / away : 0.0;
    wanted.x = share * north;
    wanted.y = share * east;
    if (reference.target == Target::path) {
      wanted.x += reference.velocity_m_s.x;
      wanted.y += reference.velocity_m_s.y;
    } else {
      wanted.z = 0;
    }
  }
  const double speed = std::sqrt(wanted.x * wanted.x + wanted.y * wanted.y);
  if (speed > settings.most_speed_m_s) {
    wanted.x *= settings.most_speed_m_s / speed;
    wanted.y *= settings.most_speed_m_s / speed;
  }
  if (reference.target == Target::cruise) {
    wanted.x += reference.carried_m_s.x;
    wanted.y += reference.carried_m_s.y;
  }
  const double down = approach_speed(autopilot.vertical.outer_per_s, std::abs(outset.too_shallow_m),
                                     settings.most_descent_m_s + settings.most_climb_m_s,
                                     0.5 * settings.most_acceleration_m_s2);
  wanted.z = std::clamp(wanted.z + (outset.too_shallow_m < 0 ? -down : down),
                        -settings.most_climb_m_s, settings.most_descent_m_s);
  return wanted;
}

Course crabbing(const Course& course, double speed_m_s, const Triple<double>& water_m_s) noexcept {
  const double across = course.north * water_m_s.y - course.east * water_m_s.x;
  const double lead = std::clamp(-across / std::max(speed_m_s, 1e-3), -1.0, 1.0);
  const double along = std::sqrt(1 - lead * lead);
  return {along * course.north - lead * course.east, along * course.east + lead * course.north};
}

Course crabbing_over_ground(const Course& course, double speed_m_s,
                            const Triple<double>& water_m_s) noexcept {
  const double across = course.north * water_m_s.y - course.east * water_m_s.x;
  const double ahead = std::max(speed_m_s, 1e-3);
  const double through = std::sqrt(ahead * ahead + across * across);
  const double lead = -across / through;
  const double along = ahead / through;
  return {along * course.north - lead * course.east, along * course.east + lead * course.north};
}

AheadLoop ahead_loop(const Autopilot& a, const Measured& measured, const Way& way, double dt_s,
                     ControlState& state) noexcept {
  const double most_change = a.settings.most_acceleration_m_s2 * dt_s;
  state.wanted_ahead_m_s +=
      std::clamp(way.ahead_m_s - state.wanted_ahead_m_s, -most_change, most_change);
  const double over_ground = measured.nu.linear.x;
  if (way.is_over_ground)
    return {measured.has_log() ? measured.log_m_s : over_ground,
            state.wanted_ahead_m_s - over_ground};
  if (!measured.has_log()) return {state.wanted_ahead_m_s, 0};
  return {measured.log_m_s, state.wanted_ahead_m_s - measured.log_m_s};
}

double push_ahead_n(const Autopilot& a, const Way& way, double push_m_s2,
                    const ControlState& state) noexcept {
  const double wanted =
      a.mass.entry[0][0] * push_m_s2 + resistance(a, {{state.wanted_ahead_m_s, 0, 0}, {}}).linear.x;
  if (!way.is_over_ground) return wanted;
  return std::max(wanted, resistance(a, {{a.settings.least_speed_m_s, 0, 0}, {}}).linear.x);
}

Way way_along(const Autopilot& a, const Measured& measured, const Reference& reference,
              const Triple<double>& wanted_m_s, const Outset& outset, double dt_s,
              ControlState& state) noexcept {
  const Triple<double>& v = reference.velocity_m_s;
  const bool is_over_ground = reference.is_over_ground;
  const double speed = std::clamp(std::sqrt(v.x * v.x + v.y * v.y),
                                  is_over_ground ? 0.0 : a.settings.least_speed_m_s,
                                  most_over_ground_m_s(a, is_over_ground));
  const double size = std::sqrt(wanted_m_s.x * wanted_m_s.x + wanted_m_s.y * wanted_m_s.y);
  if (!(size > 1e-6)) return {outset.bow, speed, 0, is_over_ground};
  const Course course{wanted_m_s.x / size, wanted_m_s.y / size};
  const Triple<double> drift{measured.water_m_s.x - state.drift_north_m_s,
                             measured.water_m_s.y - state.drift_east_m_s, 0};
  Way way{crabbing(course, speed, drift), speed, 0};
  if (is_over_ground) {
    const Course heading = crabbing_over_ground(course, speed, drift);
    // What the bow makes of a velocity along the course.
    const double share = heading.north * course.north + heading.east * course.east;
    way = {heading, share * speed, 0, true};
  }
  // On its heading, what goes across the course is drift.
  if (std::abs(turn_rad(outset.bow, way.heading)) < 0.3) {
    const double across =
        course.north * outset.velocity_m_s.y - course.east * outset.velocity_m_s.x;
    const double learned = 0.35 * a.heading.outer_per_s * dt_s * across;
    const double most = a.settings.most_speed_m_s;
    state.drift_north_m_s = std::clamp(state.drift_north_m_s + course.east * learned, -most, most);
    state.drift_east_m_s = std::clamp(state.drift_east_m_s - course.north * learned, -most, most);
  }
  return way;
}

Spatial<double> resistance(const Autopilot& autopilot, const Spatial<double>& nu_r) noexcept {
  const Spatial<double>& l = autopilot.linear_damping;
  const Spatial<double>& q = autopilot.quadratic_damping;
  const auto along = [](double linear, double quadratic, double speed) {
    return (linear + quadratic * std::abs(speed)) * speed;
  };
  return {
      {along(l.linear.x, q.linear.x, nu_r.linear.x), along(l.linear.y, q.linear.y, nu_r.linear.y),
       along(l.linear.z, q.linear.z, nu_r.linear.z)},
      {along(l.angular.x, q.angular.x, nu_r.angular.x),
       along(l.angular.y, q.angular.y, nu_r.angular.y),
       along(l.angular.z, q.angular.z, nu_r.angular.z)}};
}

}  // namespace slackwater::twin
