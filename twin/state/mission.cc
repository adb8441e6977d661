#include "twin/state/mission.h"

#include <algorithm>
#include <cmath>

#include "fields/base/turn.h"
#include "twin/control/control_loop.h"
#include "twin/state/follow_manoeuvre.h"

namespace slackwater::twin {
namespace {

Course bow_course(const Attitude<double>& attitude) { return bow_of(rotation_of(attitude)); }

Reference station(const Triple<double>& place_m, const Course& heading) {
  Reference reference;
  reference.target = Target::station;
  reference.position_m = place_m;
  reference.heading = heading;
  return reference;
}

/// The share of the leg that lies behind, 0 to 1.
double progress(const LegPlace& place) {
  return place.length_m > 0 ? std::clamp(place.along_m / place.length_m, 0.0, 1.0) : 1.0;
}

/// What the published follower sets: speed and rate of turn, at the depth of the leg beside the
/// vehicle.
Reference followed(const Mission& mission, const Measured& measured, double dt_s,
                   MissionState& state) {
  const EulerAngles angles = euler_angles(measured.attitude);
  const std::size_t before = state.route.next();
  follow(mission.follower, state.follower, state.route, measured.position_m, angles.yaw_rad, dt_s);
  state.waypoints_taken += state.route.next() - before;
  state.followed_yaw_rad =
      wrapped_rad(state.followed_yaw_rad + state.follower.yaw_rate_rad_s * dt_s);
  const Triple<double>& from = state.route.from();
  const Triple<double> to = state.route.to().position_m;
  Reference reference;
  reference.target = Target::cruise;
  reference.position_m = from + progress(place_on_leg(from, to, measured.position_m)) * (to - from);
  reference.velocity_m_s = {state.follower.speed_m_s, 0, 0};
  reference.heading = course_of(state.followed_yaw_rad);
  return reference;
}

/// Ahead at the speed and along the course that lead to where the track is.
Reference pursued(const Mission& mission, const Measured& measured, const TrackState& wanted,
                  double dt_s, MissionState& state) {
  learn_drift(mission.pursuit, wanted, measured.position_m, dt_s, state.track_drift_m_s);
  const double yaw_rad = bearing_rad(bow_course(measured.attitude));
  const Heading heading = pursue(mission.pursuit, wanted, measured.position_m,
                                 measured.water_m_s + state.track_drift_m_s, yaw_rad);
  Reference reference;
  reference.target = Target::cruise;
  reference.position_m = state.kept_m;
  reference.velocity_m_s = {heading.speed_m_s, 0, 0};
  reference.heading = course_of(heading.yaw_rad);
  return reference;
}

/// Without a way of its own. What ends a time on board, or by those on board, is decided at
/// barriers.
bool waits(const ScenarioTask& task) {
  return task.kind == ScenarioTask::Kind::hold || task.kind == ScenarioTask::Kind::aboard ||
         task.kind == ScenarioTask::Kind::stand_by;
}

const ActuatorPlan* plan_of(const Mission& mission, const MissionState& state) noexcept {
  if (state.is_rerouted || state.is_done || state.task >= mission.actuators.size()) return nullptr;
  const ActuatorPlan& plan = mission.actuators[state.task];
  return plan.is_there() ? &plan : nullptr;
}

const ManoeuvrePlan* manoeuvre_of(const Mission& mission, const MissionState& state) noexcept {
  if (state.is_rerouted || state.is_done || state.task >= mission.manoeuvres.size()) return nullptr;
  const ManoeuvrePlan& plan = mission.manoeuvres[state.task];
  return plan.is_there ? &plan : nullptr;
}

/// What comes next begins where the vehicle is, at the depth that it kept.
void leave_as_it_is(bool keeps_depth, const Mission& mission, const Measured& measured,
                    MissionState& state) {
  const double kept_z = keeps_depth ? state.kept_m.z : measured.position_m.z;
  state.kept_m = {measured.position_m.x, measured.position_m.y, kept_z};
  state.kept_heading = bow_course(measured.attitude);
  end_task(mission, state);
}

/// What is kept while actuators go by a table; of the rest what is, so that nothing acts for it.
Reference kept(const ActuatorPlan& plan, const Measured& measured, const MissionState& state) {
  const double ahead_m_s = measured.has_log() ? measured.log_m_s : measured.nu.linear.x;
  Reference reference;
  reference.target = Target::cruise;
  reference.position_m = measured.position_m;
  if (plan.keeps_depth) reference.position_m.z = state.kept_m.z;
  reference.heading = plan.keeps_heading ? state.kept_heading : bow_course(measured.attitude);
  if (plan.keeps_speed)
    reference.velocity_m_s = {plan.speed_m_s, 0, 0};
  else
    reference.velocity_m_s = {ahead_m_s, measured.nu.linear.y, 0};
  return reference;
}

void begin_task(const Mission& mission, const Measured& measured, const Triple<double>& offset_m,
                double t_s, MissionState& state) {
  const ScenarioTask& task = mission.tasks[state.task];
  state.has_begun = true;
  state.held_s = 0;
  if (waits(task)) {
    // Where the task before it ended, not where the vehicle has drifted to.
    if (state.task == 0) state.kept_m = measured.position_m;
    return;
  }
  if (task.kind == ScenarioTask::Kind::follow_track) {
    state.track_drift_m_s = {};
    return;
  }
  if (task.kind == ScenarioTask::Kind::actuators) {
    if (state.task == 0) state.kept_m = measured.position_m;
    state.kept_heading = bow_course(measured.attitude);
    state.route = {};
    state.row = 0;
    return;
  }
  if (task.kind == ScenarioTask::Kind::manoeuvre) {
    if (state.task == 0) state.kept_m = measured.position_m;
    begin_manoeuvre(mission.manoeuvres[state.task], measured, t_s, state);
    return;
  }
  const Triple<double>& from_m = state.task == 0 ? measured.position_m : state.kept_m;
  state.route = Route(task.drifts ? from_m - offset_m : from_m, task.waypoints);
  state.followed_yaw_rad = euler_angles(measured.attitude).yaw_rad;
  state.follower = {};
}

}  // namespace

void end_task(const Mission& mission, MissionState& state) {
  state.has_begun = false;
  ++state.task;
  state.is_done = state.task >= mission.tasks.size();
}

MissionState begun(const Measured& measured) {
  MissionState state;
  state.kept_m = measured.position_m;
  state.kept_heading = bow_course(measured.attitude);
  return state;
}

MissionState nothing_to_do(const Measured& measured) {
  MissionState way = begun(measured);
  way.task = static_cast<std::size_t>(-1);
  way.is_done = true;
  return way;
}

ActuatorsAsked actuators_asked(const Mission& mission, const MissionState& state) noexcept {
  const ActuatorPlan* const plan = plan_of(mission, state);
  if (plan == nullptr || !state.has_begun) return {};
  return {plan, &plan->steps[state.row].asked};
}

const ManoeuvrePlan* manoeuvre_under_way(const Mission& mission,
                                         const MissionState& state) noexcept {
  return state.has_begun ? manoeuvre_of(mission, state) : nullptr;
}

bool drifts(const Mission& mission, const MissionState& state) noexcept {
  return !state.is_rerouted && state.task < mission.tasks.size() &&
         mission.tasks[state.task].drifts;
}

Reference next_reference(const Mission& mission, const Measured& over_ground,
                         const MovingFrame& datum, double t_s, double dt_s, MissionState& state) {
  // Each pass ends a task or a route, and there are finitely many.
  while (true) {
    const bool is_adrift = drifts(mission, state);
    // What a route is followed by: places and attitude, which do without the water.
    const Measured in_datum = is_adrift ? seen_from(datum, over_ground, false) : Measured{};
    const Measured& measured = is_adrift ? in_datum : over_ground;
    state.offset_m = is_adrift ? datum.offset_m : Triple<double>{};
    state.is_done = state.task >= mission.tasks.size();
    if (!state.is_done && !state.has_begun && !state.is_rerouted)
      begin_task(mission, over_ground, datum.offset_m, t_s, state);
    const ScenarioTask* task = state.is_done ? nullptr : &mission.tasks[state.task];
    const bool follows = task != nullptr && task->kind == ScenarioTask::Kind::follow_track;
    if (follows && !state.is_rerouted) {
      const TrackState wanted = task->follow->track->at(t_s);
      if (wanted.status == TrackStatus::after_end) {
        end_task(mission, state);
        continue;
      }
      if (!wanted.is_known()) return station(state.kept_m, state.kept_heading);
      // At its own depth or height.
      state.kept_m = {wanted.position_m.x, wanted.position_m.y, state.kept_m.z};
      state.kept_heading = bow_course(measured.attitude);
      return pursued(mission, measured, wanted, dt_s, state);
    }
    if (const ActuatorPlan* const plan = plan_of(mission, state)) {
      constexpr double soon_s = 1e-6;  // what rounding leaves of a number of steps
      if (state.held_s >= task->hold_s - soon_s) {
        leave_as_it_is(plan->keeps_depth, mission, over_ground, state);
        continue;
      }
      while (state.row + 1 < plan->steps.size() &&
             state.held_s >= plan->steps[state.row + 1].at_s - soon_s)
        ++state.row;
      state.held_s += dt_s;
      return kept(*plan, measured, state);
    }
    if (const ManoeuvrePlan* const plan = manoeuvre_of(mission, state)) {
      if (go_on(*plan, over_ground, t_s, dt_s, state))
        return reference_of(*plan, over_ground, state);
      leave_as_it_is(plan->keeps_depth, mission, over_ground, state);
      continue;
    }
    const bool holds = state.is_done || waits(mission.tasks[state.task]);
    if (holds && !state.is_rerouted) {
      if (!state.is_done && mission.tasks[state.task].kind == ScenarioTask::Kind::hold &&
          state.held_s >= mission.tasks[state.task].hold_s) {
        end_task(mission, state);
        continue;
      }
      if (state.is_done || mission.tasks[state.task].kind == ScenarioTask::Kind::hold)
        state.held_s += dt_s;
      return station(state.kept_m, state.kept_heading);
    }
    if (mission.has_follower) {
      if (!state.route.is_done()) return followed(mission, measured, dt_s, state);
    } else if (!state.route.is_done()) {
      const std::size_t before = state.route.next();
      const Reference reference = reference_along(mission.guidance, state.route, measured);
      state.waypoints_taken += state.route.next() - before;
      if (!state.route.is_done()) return reference;
    }
    state.kept_m = state.route.is_empty() ? over_ground.position_m : state.route.to().position_m;
    if (is_adrift && !state.route.is_empty()) state.kept_m = state.kept_m + datum.offset_m;
    state.kept_heading = bow_course(measured.attitude);
    state.is_rerouted = false;
    if (!holds && !follows) end_task(mission, state);
  }
}

void replace_waypoints(MissionState& state, const Measured& measured,
                       std::span<const Waypoint> waypoints) {
  state.route = Route(measured.position_m, waypoints);
  state.is_rerouted = true;
  state.follower = {};
  state.followed_yaw_rad = euler_angles(measured.attitude).yaw_rad;
}

TrackError track_error(const MissionState& state, const Triple<double>& at_m) noexcept {
  const bool has_leg = state.is_rerouted || (!state.is_done && state.has_begun);
  if (!has_leg || state.route.is_done()) return {0, at_m.z - state.kept_m.z};
  const Triple<double> position_m = at_m - state.offset_m;
  const Triple<double>& from = state.route.from();
  const Triple<double> to = state.route.to().position_m;
  const LegPlace place = place_on_leg(from, to, position_m);
  return {place.across_m, position_m.z - (from.z + progress(place) * (to.z - from.z))};
}

}  // namespace slackwater::twin
