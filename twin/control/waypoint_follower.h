#pragma once
#include "twin/control/pid.h"
#include "twin/control/route.h"

namespace slackwater::twin {

/// How waypoints are followed by setting a speed and a rate of turn, as the public simulators do:
/// heading by a PID controller on the bearing of the next waypoint, speed all ahead or all astern
/// within its bounds.
struct WaypointFollower {
  double tolerance_m = 0.5;
  double depth_tolerance_m = 0.5;
  double acceleration_m_s2 = 0.5;
  double yaw_acceleration_rad_s2 = 0.5;
  double least_speed_m_s = 0;
  double most_speed_m_s = 5;
  double most_yaw_rate_rad_s = 1;
  Pid heading{0.8, 0.05, 0.4};
  /// Slows down so that the waypoint lies outside of the tightest turn: else one that is near and
  /// abeam is circled for ever. The published settings do not.
  bool slows_to_turn = true;
};

/// Of the LOTUSim-Energy paper, which states all but the gains (those are of the public code).
[[nodiscard]] WaypointFollower paper_follower();
/// naval-group/LOTUSim@b4f9a9c, systems/waypoint_follower.
[[nodiscard]] WaypointFollower public_follower();

/// The vehicle at rest, the integral at zero.
struct FollowerState {
  double speed_m_s = 0;
  double yaw_rate_rad_s = 0;
  double previous_error_rad = 0;
  PidState heading;
};

/// One step: moves the state's speed and rate of turn, which are what is asked of the vehicle, and
/// takes the waypoints that are reached. When the route is done both go to zero within the limits.
void follow(const WaypointFollower& follower, FollowerState& state, Route& route,
            const Triple<double>& position_m, double yaw_rad, double dt_s);

}  // namespace slackwater::twin
