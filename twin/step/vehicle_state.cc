#include "twin/step/vehicle_state.h"

#include "fields/base/check.h"

namespace slackwater::twin {

StepPlan plan_step(const Vehicle& vehicle, double dt_s, double held_voltage_v) {
  expects(dt_s > 0 && dt_s <= vehicle.largest_step_s * (1 + 1e-12),
          "a step is positive and at most the vehicle's largest");
  expects(vehicle.thrusters.size() <= most_thruster_kinds,
          "a vehicle has at most four kinds of thruster");
  StepPlan plan;
  plan.dt_s = dt_s;
  for (std::size_t i = 0; i < vehicle.thrusters.size(); ++i)
    plan.thruster[i] = lag_step(vehicle.thrusters[i].rise_time_constant_s,
                                vehicle.thrusters[i].fall_time_constant_s, dt_s);
  plan.rudder_step = 1 - lag_step(vehicle.rudder.lag_s, vehicle.rudder.lag_s, dt_s).rise_left;
  plan.elevator_step = 1 - lag_step(vehicle.elevator.lag_s, vehicle.elevator.lag_s, dt_s).rise_left;
  if (vehicle.battery) plan.battery = battery_step(*vehicle.battery, dt_s);
  plan.held_voltage_v = held_voltage_v;
  return plan;
}

VehicleState<double> placed(const Vehicle& vehicle, const Triple<double>& position_m,
                            double yaw_rad, double state_of_charge) {
  expects(state_of_charge >= 0 && state_of_charge <= 1, "a state of charge is from 0 to 1");
  VehicleState<double> state;
  state.body.position_m = position_m;
  state.body.attitude = attitude_of({0, 0, yaw_rad});
  if (vehicle.battery) {
    state.battery = rested(*vehicle.battery, state_of_charge);
    state.bus_voltage_v = rest_voltage_v(*vehicle.battery, state.battery);
  }
  return state;
}

}  // namespace slackwater::twin
