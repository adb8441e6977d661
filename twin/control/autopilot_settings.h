#pragma once
#include "fields/base/config.h"
#include "twin/body/vehicle_kind.h"

namespace slackwater::twin {

/// How an autopilot is to behave. `autopilot` of a vehicle's YAML; each key has a default of its
/// kind.
struct AutopilotSettings {
  double horizontal_period_s = 0;  ///< natural periods of the closed loops, undamped
  double vertical_period_s = 0;
  double heading_period_s = 0;
  double tilt_period_s = 0;  ///< of roll and pitch
  double damping_ratio = 0;
  double most_speed_m_s = 0;  ///< 0: 0.95 of what the thrusters give
  double most_acceleration_m_s2 = 0;
  double most_climb_m_s = 0;
  double most_descent_m_s = 0;
  double most_yaw_rate_rad_s = 0;
  double most_tilt_rad = 0;           ///< of a multirotor; the pitch of an AUV
  double least_speed_m_s = 0;         ///< of an AUV, for its fins to steer
  double holding_radius_m = 0;        ///< of an AUV, which circles where others stand still
  bool current_feed_forward = false;  ///< takes the drag of the known current beforehand
};

/// Reads `autopilot`, or takes the defaults of the kind. Refuses loops too fast for the vehicle's
/// step or for the loops inside them.
/// @param largest_step_s  of the vehicle
[[nodiscard]] AutopilotSettings read_autopilot(const Config& vehicle, VehicleKind kind,
                                               double largest_step_s);
[[nodiscard]] AutopilotSettings default_autopilot(VehicleKind kind) noexcept;

}  // namespace slackwater::twin
