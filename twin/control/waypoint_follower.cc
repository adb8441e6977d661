#include "twin/control/waypoint_follower.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/turn.h"

namespace slackwater::twin {
namespace {

double approached(double value, double target, double most_change) {
  return value + std::clamp(target - value, -most_change, most_change);
}

/// The speed at which a turn of `error` brings the vehicle to a place that far away: on a circle of
/// radius U/r a chord of `distance` turns by twice the angle to it.
double turning_speed_m_s(const WaypointFollower& f, double error_rad, double distance_m) {
  const double sine = std::abs(error_rad) < constants::pi / 2 ? std::sin(std::abs(error_rad)) : 1.0;
  if (sine < 1e-6) return f.most_speed_m_s;
  return 0.5 * f.most_yaw_rate_rad_s * distance_m / (2 * sine);  // half of what would just do
}

}  // namespace

WaypointFollower paper_follower() {
  WaypointFollower f;
  f.yaw_acceleration_rad_s2 = 0.01;
  f.least_speed_m_s = 1;
  f.most_speed_m_s = 10;
  f.most_yaw_rate_rad_s = 0.05;
  f.slows_to_turn = false;
  return f;
}

WaypointFollower public_follower() {
  WaypointFollower f;
  f.slows_to_turn = false;
  return f;
}

void follow(const WaypointFollower& f, FollowerState& state, Route& route,
            const Triple<double>& position_m, double yaw_rad, double dt_s) {
  route.advance(position_m, f.tolerance_m, f.depth_tolerance_m, 0);
  double speed = 0;
  double yaw_rate = 0;
  if (!route.is_done()) {
    const Triple<double> left = route.to().position_m - position_m;
    const double away = std::hypot(left.x, left.y);
    const double error = wrapped_rad(std::atan2(left.y, left.x) - yaw_rad);
    const double rate = wrapped_rad(error - state.previous_error_rad) / dt_s;
    state.previous_error_rad = error;
    yaw_rate = std::clamp(output_of(f.heading, state.heading, error, rate, dt_s),
                          -f.most_yaw_rate_rad_s, f.most_yaw_rate_rad_s);
    const double stopping = state.speed_m_s * state.speed_m_s / (2 * f.acceleration_m_s2);
    double most = route.to().speed_m_s > 0 ? std::min(route.to().speed_m_s, f.most_speed_m_s)
                                           : f.most_speed_m_s;
    if (f.slows_to_turn) most = std::min(most, turning_speed_m_s(f, error, away));
    speed = route.remaining_m(position_m) > stopping ? most : 0.0;
    speed = std::clamp(speed, f.least_speed_m_s, f.most_speed_m_s);
  }
  state.speed_m_s = approached(state.speed_m_s, speed, f.acceleration_m_s2 * dt_s);
  state.yaw_rate_rad_s =
      approached(state.yaw_rate_rad_s, yaw_rate, f.yaw_acceleration_rad_s2 * dt_s);
}

}  // namespace slackwater::twin
