#pragma once
#include <cstddef>
#include <vector>

#include "twin/control/guidance.h"
#include "twin/control/moving_frame.h"
#include "twin/control/waypoint_follower.h"
#include "twin/scenario/scenario.h"
#include "twin/state/actuator_plan.h"
#include "twin/state/manoeuvre_plan.h"
#include "twin/traffic/pursuit.h"

namespace slackwater::twin {

/// What a vehicle is to do, one task after the other: what of it does not change.
struct Mission {
  std::vector<ScenarioTask> tasks;
  Guidance guidance;
  /// Set: speed and rate of turn by the published follower instead of along the path.
  bool has_follower = false;
  WaypointFollower follower;
  Pursuit pursuit;  ///< of tracks
  /// Of each task, where any goes by a table of actuators; of the others none is there.
  std::vector<ActuatorPlan> actuators;
  std::vector<ManoeuvrePlan> manoeuvres;  ///< likewise
};

/// How far it has come.
struct MissionState {
  std::size_t task = 0;
  bool has_begun = false;  ///< the task
  bool is_done = false;    ///< all tasks; the vehicle keeps its last place
  double held_s = 0;       ///< of a hold, a table of actuators or a manoeuvre
  std::size_t row = 0;     ///< of that table, in force
  Triple<double> kept_m;   ///< where the vehicle is held
  Course kept_heading;
  Route route;
  bool is_rerouted =
      false;  ///< the route is not that of the task, but one that was put in its place
  std::size_t waypoints_taken = 0;
  FollowerState follower;
  double followed_yaw_rad = 0;
  Triple<double> track_drift_m_s;  ///< learned while a track is followed
  Triple<double> offset_m;         ///< of the frame that the route is in
  ManoeuvreState manoeuvre;        ///< of the task under way
  std::vector<TaskOrder> orders;   ///< of all manoeuvres so far, since each began last
};

/// The vehicle before its first task, which is to begin where it is.
[[nodiscard]] MissionState begun(const Measured& measured);

/// A mission without tasks: a route that is put into it is followed, then its end is held; without
/// one the vehicle keeps the place where it is.
[[nodiscard]] MissionState nothing_to_do(const Measured& measured);

/// Ends the task under way.
void end_task(const Mission& mission, MissionState& state);

/// Whether what is done now is in the frame of the vehicle's datum.
[[nodiscard]] bool drifts(const Mission& mission, const MissionState& state) noexcept;

/// What actuators do by a table in this step, and its plan.
struct ActuatorsAsked {
  const ActuatorPlan* plan = nullptr;  ///< null: none is under way
  const ActuatorValues* asked = nullptr;
};
[[nodiscard]] ActuatorsAsked actuators_asked(const Mission& mission,
                                             const MissionState& state) noexcept;

/// The manoeuvre under way; null: none is.
[[nodiscard]] const ManoeuvrePlan* manoeuvre_under_way(const Mission& mission,
                                                       const MissionState& state) noexcept;

/// The reference of a step, and moves the mission on: takes waypoints that are reached, goes to the
/// next task when one is done. On a route the place is the foot of the vehicle on its leg and the
/// velocity that of the leg; after its end, and in a hold, it is a station. A track is followed in
/// time while it is known: before it begins and where it is silent the vehicle waits, and where it
/// ends so does the task. While actuators go by a table, velocity, heading and depth are those to
/// be kept, and of what is not kept those that the vehicle has. Likewise in a manoeuvre.
/// A task that drifts is done in the frame of the datum, and so is its reference; the place that is
/// kept after it is over ground.
/// @param t_s    since the run's epoch
/// @param datum  the frame that drifting tasks are in
[[nodiscard]] Reference next_reference(const Mission& mission, const Measured& measured,
                                       const MovingFrame& datum, double t_s, double dt_s,
                                       MissionState& state);

/// Puts other waypoints in the place of what is left of the route under way; a hold goes on at the
/// last of them, and so does a vehicle that has done all its tasks. The leg starts at the vehicle.
/// No waypoints: it stays where it is.
void replace_waypoints(MissionState& state, const Measured& measured,
                       std::span<const Waypoint> waypoints);

/// Distance from the leg under way, in the plane (positive: right of it) and in depth (positive:
/// below it). Without a leg, from the place that is held, in depth alone: craft that cannot stand
/// still circle it.
struct TrackError {
  double across_m = 0;
  double below_m = 0;
};
[[nodiscard]] TrackError track_error(const MissionState& state,
                                     const Triple<double>& position_m) noexcept;

}  // namespace slackwater::twin
