#include "twin/agent/helm.h"

#include <algorithm>
#include <cmath>

#include "twin/agent/waypoints_home.h"
#include "twin/control/control_loop.h"
#include "twin/mission/way_round.h"

namespace slackwater::twin {
namespace {

/// While it turns or sinks, what it is to keep is no further ahead of it than this.
constexpr double most_lead_rad = 0.35;
constexpr double most_lead_m = 0.5;
constexpr double most_lead_s = 1;

Course turned(const Course& course, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {course.north * c - course.east * s, course.east * c + course.north * s};
}

std::vector<Waypoint> home_of(const Agent& agent, const AgentState& state) {
  if (agent.conduct) return waypoints_home(agent, state);
  return way_round(state.vehicle.body.position_m, state.helm.start_m,
                   agent.water->environment().structures, Conduct{}.clear_m);
}

/// The course to be kept, moved on by a step of turning.
void turn(const Autopilot& autopilot, const Course& bow, double dt_s, HelmState& helm) {
  const double rate =
      std::clamp(helm.velocity.yaw_rate_rad_s, -autopilot.settings.most_yaw_rate_rad_s,
                 autopilot.settings.most_yaw_rate_rad_s);
  if (rate == 0) return;
  helm.heading = turned(helm.heading, rate * dt_s);
  const double ahead_rad = turn_rad(bow, helm.heading);
  if (std::abs(ahead_rad) > most_lead_rad)
    helm.heading = turned(bow, std::copysign(most_lead_rad, ahead_rad));
}

/// The depth to be kept, moved on by a step of sinking. What swims stays in the water.
/// @return the velocity down
double sink(bool swims, double depth_m, double dt_s, HelmState& helm) {
  const double down_m_s = helm.velocity.heave_m_s;
  if (down_m_s != 0) {
    const double reach_m = most_lead_m + most_lead_s * std::abs(down_m_s);
    helm.depth_m = std::clamp(helm.depth_m + down_m_s * dt_s, depth_m - reach_m, depth_m + reach_m);
  }
  if (!swims || helm.depth_m > 0) return down_m_s;
  helm.depth_m = 0;
  return std::max(down_m_s, 0.0);
}

Reference velocity_reference(const Agent& agent, const Measured& measured,
                             const Triple<double>& stream_m_s, HelmState& helm) {
  const Autopilot& autopilot = *agent.autopilot;
  const Course bow = bow_of(rotation_of(measured.attitude));
  const double dt_s = agent.plan.dt_s;
  const bool swims =
      agent.vehicle->kind != VehicleKind::uav && agent.vehicle->body.hull.strips == 0;
  turn(autopilot, bow, dt_s, helm);
  const double down_m_s = sink(swims, measured.position_m.z, dt_s, helm);
  Reference reference;
  reference.target = Target::cruise;
  reference.position_m = {measured.position_m.x, measured.position_m.y, helm.depth_m};
  // So far ahead of the bow that the heading's loop turns it at that rate.
  const double lead = helm.velocity.yaw_rate_rad_s / autopilot.heading.outer_per_s;
  reference.heading = turned(helm.heading, 2 * std::atan(0.5 * lead));
  reference.velocity_m_s = {helm.velocity.surge_m_s, helm.velocity.sway_m_s, down_m_s};
  if (!goes_by_ground(autopilot)) return reference;
  // Along and across the bow as it lies, in the axes of the heading that is asked for.
  const Course& axes = reference.heading;
  const double cosine = axes.north * bow.north + axes.east * bow.east;
  const double sine = axes.north * bow.east - axes.east * bow.north;
  const HelmVelocity& v = helm.velocity;
  reference.velocity_m_s.x = cosine * v.surge_m_s - sine * v.sway_m_s;
  reference.velocity_m_s.y = sine * v.surge_m_s + cosine * v.sway_m_s;
  if (autopilot.kind != VehicleKind::uav) reference.carried_m_s = {stream_m_s.x, stream_m_s.y, 0};
  return reference;
}

}  // namespace

void take_helm(const HelmDue& due, double t_s, const Agent& agent, AgentState& state) {
  HelmState& helm = state.helm;
  const HelmMode before = helm.mode;
  helm.mode = due.mode;
  helm.cause = due.cause;
  helm.renewed_s = t_s;
  if (before == due.mode && must_be_renewed(due.mode)) return;
  helm.since_s = t_s;
  helm.is_loop = false;
  helm.rounds = 0;
  state.headway.least_at_s = -1;
  if (is_by_hand(before)) {
    // What it asked for before is long past; what pushes steadily still does.
    state.control.is_engaged = 0;
    state.control.kept_north = state.control.kept_east = 0;
  }
  const Measured known = known_of(agent, state);
  const std::size_t waypoints_taken = helm.way.waypoints_taken;
  helm.way = nothing_to_do(known);
  helm.way.waypoints_taken = waypoints_taken;
  if (due.mode == HelmMode::velocity) {
    helm.heading = bow_of(rotation_of(known.attitude));
    helm.depth_m = known.position_m.z;
  }
  if (due.mode == HelmMode::home) replace_waypoints(helm.way, known, home_of(agent, state));
}

void give_back(HelmCause cause, double t_s, const Agent& agent, AgentState& state) {
  if (!state.helm.is_helmed()) return;
  const std::size_t waypoints_taken = state.helm.way.waypoints_taken;
  take_helm({HelmMode::own, cause}, t_s, agent, state);
  state.helm.way = {};
  state.helm.way.waypoints_taken = waypoints_taken;
  const Measured known = known_of(agent, state);
  state.mission.followed_yaw_rad = euler_angles(known.attitude).yaw_rad;
  ConductState& own = state.conduct;
  if (!agent.conduct || own.doing == Doing::task || !own.way.is_rerouted) return;
  if (own.doing == Doing::way_home) {
    replace_waypoints(own.way, known, waypoints_home(agent, state));
  } else if (!own.way.route.is_done()) {
    replace_waypoints(own.way, known, std::vector<Waypoint>{own.way.route.to()});
  }
}

bool must_come_home(const Agent& agent, const AgentState& state) noexcept {
  return agent.conduct && agent.conduct->minds_reserve && !state.conduct.is_aboard &&
         !reserve_holds(*agent.conduct, state.conduct);
}

void mind_helm(const Agent& agent, double t_s, AgentState& state) {
  HelmState& helm = state.helm;
  if (!helm.is_helmed() || state.halt != Halt::none) return;
  if (helm.mode == HelmMode::waypoints && !helm.way.is_rerouted) {
    helm.mode = HelmMode::hold;
    helm.cause = HelmCause::list_done;
    helm.since_s = helm.renewed_s = t_s;
  }
  const HelmDue due =
      helm_due(agent.helm, helm.mode, helm.cause, helm.since_s, helm.renewed_s, t_s);
  if (due.mode != helm.mode) take_helm(due, t_s, agent, state);
}

Reference helm_reference(const Agent& agent, const Measured& measured,
                         const Triple<double>& stream_m_s, AgentState& state) {
  HelmState& helm = state.helm;
  if (helm.mode == HelmMode::velocity) return velocity_reference(agent, measured, stream_m_s, helm);
  const auto next = [&] {
    return next_reference(agent.mission, measured, {}, 0, agent.plan.dt_s, helm.way);
  };
  const Reference reference = next();
  if (!helm.is_loop || helm.way.is_rerouted) return reference;
  ++helm.rounds;
  helm.way.route.begin_again();
  helm.way.is_rerouted = true;
  return next();
}

}  // namespace slackwater::twin
