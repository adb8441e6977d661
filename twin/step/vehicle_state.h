#pragma once
#include "twin/battery/battery_step.h"
#include "twin/thruster/lag.h"
#include "twin/vehicle/vehicle.h"

namespace slackwater::twin {

/// All that changes of a vehicle. Made of numbers only, so that it is copied, stored and compared
/// as a block of them.
template <typename Real>
struct VehicleState {
  BodyState<Real> body;
  std::array<Real, most_mounts>
      thruster{};  ///< behind its lag: command, shaft speed or thrust, as its kind has it
  Real rudder_rad{};
  Real elevator_rad{};
  Real moving_mass_m{};
  Real volume_m3{};
  BatteryState<Real> battery;
  Real bus_voltage_v{};
  Real current_a{};
  Real electrical_w{};                       ///< drawn in the last step, hotel load and all
  Real drawn_j{};                            ///< electrical energy, whatever gave it
  Real fuel_kg{};                            ///< burnt
  std::array<Real, most_mounts> thrust_n{};  ///< in the last step
};

/// What is asked of the vehicle during a step.
template <typename Real>
struct VehicleCommand {
  std::array<Real, most_mounts> thruster{};
  Real rudder_rad{};
  Real elevator_rad{};
  Real moving_mass_m{};
  Real volume_m3{};
};

/// What is around the vehicle during a step, NED.
template <typename Real>
struct Surroundings {
  FluidMotion<Real> water;
  WaterAtStrips<Real> at_strips;
  Triple<Real> wind_m_s;  ///< of the air, towards
  Triple<Real> pull_n;    ///< of a tether, and of those that hang from it, at the origin
  Triple<Real> turn_n_m;  ///< of those that hang from it, of one that floats
  Real height_above_m{};  ///< of the vehicle above ground or sea, for rotors
};

/// What a step of a given length needs of a vehicle, worked out once.
struct StepPlan {
  double dt_s = 0;
  std::array<LagStep, most_thruster_kinds> thruster;  ///< of each kind
  double rudder_step = 1;  ///< share of its way to what is asked that a lag lets it go in a step
  double elevator_step = 1;
  BatteryStep battery;
  double held_voltage_v = 0;  ///< above 0: the bus is held there and the battery left out
};
/// @throws ContractViolation for a step that is not positive or longer than the vehicle's largest
[[nodiscard]] StepPlan plan_step(const Vehicle& vehicle, double dt_s, double held_voltage_v = 0);

/// At a place, with a heading, at rest, the battery rested at a state of charge from 0 to 1.
[[nodiscard]] VehicleState<double> placed(const Vehicle& vehicle, const Triple<double>& position_m,
                                          double yaw_rad, double state_of_charge = 1);

}  // namespace slackwater::twin
