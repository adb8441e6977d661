#pragma once
#include <array>
#include <vector>

#include "twin/scenario/actuator_table.h"
#include "twin/step/vehicle_state.h"
#include "twin/vehicle/actuator_channels.h"

namespace slackwater::twin {

/// A table of actuators made ready for one vehicle.
struct ActuatorPlan {
  /// From a time on. Given are all thrusters and fins that the autopilot has not, those that no row
  /// has named yet at rest; of ballast what a row has named.
  struct Step {
    double at_s = 0;
    ActuatorValues asked;
  };
  std::vector<Step> steps;                    ///< the first at 0; none: it is no plan
  std::array<bool, most_channels> is_kept{};  ///< left to the autopilot
  bool keeps_depth = false;
  bool keeps_heading = false;
  bool keeps_speed = false;
  double speed_m_s = 0;  ///< to be kept

  [[nodiscard]] bool is_there() const noexcept { return !steps.empty(); }
  /// Whether anything is left to the autopilot.
  [[nodiscard]] bool keeps_any() const noexcept {
    return keeps_depth || keeps_heading || keeps_speed;
  }
};

/// @param speed_m_s  of the vehicle, where the table says none
/// @throws Error(invalid_input) with the file and the line of a row: for an actuator that the
/// vehicle has not, listing those it has; a unit that is not of it; a value beyond its range; and
/// for something to be kept for which no actuator is left
[[nodiscard]] ActuatorPlan plan_actuators(const ActuatorTable& table, const Vehicle& vehicle,
                                          double speed_m_s);

/// Puts a step of a plan in the place of what the autopilot has no say in. A moving mass and a
/// bladder that neither has stay as they are.
void put_asked(const ActuatorPlan& plan, const ActuatorValues& asked,
               const VehicleState<double>& vehicle, VehicleCommand<double>& command) noexcept;

}  // namespace slackwater::twin
