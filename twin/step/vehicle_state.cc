#include "twin/step/vehicle_state.h"

#include "fields/base/check.h"

namespace slackwater::twin {

StepPlan plan_step(const Vehicle& vehicle, double dt_s, double held_voltage_v) {
  expects(dt_s > 0 && dt_s <= vehicle.largest_step_s * (1 + 1e-12),
          "a step is positive and at most the vehicle's largest");
  StepPlan plan;
  plan.dt_s = dt_s;
  plan.thruster =
      lag_step(vehicle.thruster.rise_time_constant_s, vehicle.thruster.fall_time_constant_s, dt_s);
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
