#pragma once
#include <cstdint>

#include "twin/body/actuator_values.h"
#include "twin/sensor/camera_pointing.h"
#include "twin/state/helm_rule.h"
#include "twin/state/mission.h"

namespace slackwater::twin {

/// A velocity through the water, in axes of the vehicle's heading: ahead, to starboard and down.
/// ROVs and surface craft lie level but for the waves, so that these are their body axes; an AUV
/// climbs and dives by pitching. Those that fly have it over ground, as their autopilots do.
struct HelmVelocity {
  double surge_m_s = 0;
  double sway_m_s = 0;
  double heave_m_s = 0;       ///< down
  double yaw_rate_rad_s = 0;  ///< to starboard
};

/// What somebody outside has made of a vehicle: what is in force, since when. A value, part of
/// `AgentState`; times are of the run.
struct HelmState {
  HelmMode mode = HelmMode::own;
  HelmCause cause = HelmCause::none;
  double since_s = 0;    ///< the mode
  double renewed_s = 0;  ///< the last command of that mode
  HelmVelocity velocity;
  ActuatorValues by_hand;    ///< in units, see `SetThrusters` and `SetActuators`
  MissionState way;          ///< of waypoints, a hold and the way home; its tasks are none
  bool is_loop = false;      ///< after the last waypoint comes the first
  std::uint64_t rounds = 0;  ///< of a loop, made whole
  Course heading;            ///< kept while a velocity is in force; it turns with the yaw rate
  double depth_m = 0;        ///< likewise; it sinks with the heave
  Triple<double> start_m;    ///< where the vehicle began: home of one without a conduct
  CameraPointing camera;     ///< until its own mission is resumed

  [[nodiscard]] bool is_helmed() const noexcept { return mode != HelmMode::own; }
};

}  // namespace slackwater::twin
