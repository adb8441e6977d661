#include "twin/handling/replayed.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/body/frame.h"
#include "twin/step/soundness.h"
#include "twin/step/vehicle_step.h"
#include "twin/vehicle/actuator_channels.h"
#include "twin/vehicle/own_autopilot.h"

namespace slackwater::twin {
namespace {

constexpr double out_of_the_way_m = 1000;  // of the surface, which is not felt there

void expect_replayable(const Vehicle& vehicle, const Trial& trial) {
  expects(trial.rows() >= 2, "a trial has two rows at least");
  for (const TrialCommand& told : trial.commands)
    expects(told.value.size() == trial.rows(), "a trial has a command in each row");
  for (const TrialColumn& column : trial.measured)
    expects(column.value.size() == trial.rows(), "a trial has a value, or NaN, in each row");
  if (vehicle.kind == VehicleKind::uav)
    refuse(
        formatted("{}: the {} is a multirotor, which falls over at once without its controller; "
                  "trials are flown again of what swims or floats",
                  trial.name, vehicle.name));
  const double steps = trial.lasts_s() / vehicle.largest_step_s;
  if (!(steps <= most_trial_steps))
    refuse(
        formatted("{}: found a trial of {:.3g} h, and the {} is stepped every {:g} s; expected "
                  "at most {:.3g} h: cut the trial into shorter ones",
                  trial.name, trial.lasts_s() / 3600, vehicle.name, vehicle.largest_step_s,
                  most_trial_steps * vehicle.largest_step_s / 3600));
}

/// What a column has in the first row; nothing where it is not there or empty.
std::optional<double> first_of(const Trial& trial, TrialQuantity quantity) {
  const TrialColumn* const column = measured(trial, quantity);
  if (column == nullptr || !std::isfinite(column->value.front())) return std::nullopt;
  return column->value.front();
}

VehicleCommand<double> command_in(const Vehicle& vehicle, const Trial& trial, std::size_t row,
                                  const VehicleState<double>& now) {
  VehicleCommand<double> command;
  command.moving_mass_m = now.moving_mass_m;
  command.volume_m3 = now.volume_m3;
  for (const TrialCommand& told : trial.commands) {
    const auto channel = channel_of(vehicle, told.channel);
    expects(channel.has_value(), "a trial commands channels that the vehicle has");
    const double value = told.is_share ? channel->of_share(told.value[row])
                                       : std::clamp(told.value[row], channel->least, channel->most);
    switch (told.channel) {
      case rudder_channel:
        command.rudder_rad = value;
        break;
      case elevator_channel:
        command.elevator_rad = value;
        break;
      case moving_mass_channel:
        command.moving_mass_m = value;
        break;
      case volume_channel:
        command.volume_m3 = value;
        break;
      default:
        command.thruster[told.channel] = value;
    }
  }
  return command;
}

double first_depth_m(const Vehicle& vehicle, const Trial& trial) {
  const Body& body = vehicle.body;
  if (body.hull.strips > 0)
    return floating_depth_m(body.hull, body.mass_kg, body.fluid_density_kg_m3);
  if (trial.first_depth_m) return *trial.first_depth_m;
  return first_of(trial, TrialQuantity::down).value_or(out_of_the_way_m);
}

VehicleState<double> first_state_of(const Vehicle& vehicle, const Trial& trial, double voltage_v) {
  const auto first = [&](TrialQuantity quantity) { return first_of(trial, quantity).value_or(0); };
  VehicleState<double> state = placed(
      vehicle,
      {first(TrialQuantity::north), first(TrialQuantity::east), first_depth_m(vehicle, trial)}, 0,
      0.5);
  state.body.attitude = attitude_of(
      {first(TrialQuantity::roll), first(TrialQuantity::pitch), first(TrialQuantity::yaw)});
  const double ahead_m_s = first_of(trial, TrialQuantity::u).value_or(first(TrialQuantity::speed));
  state.body.nu = {{ahead_m_s, first(TrialQuantity::v), first(TrialQuantity::w)},
                   {first(TrialQuantity::p), first(TrialQuantity::q), first(TrialQuantity::r)}};
  if (voltage_v > 0) state.bus_voltage_v = voltage_v;
  const VehicleCommand<double> command = command_in(vehicle, trial, 0, state);
  state.thruster = command.thruster;
  state.rudder_rad = command.rudder_rad;
  state.elevator_rad = command.elevator_rad;
  state.moving_mass_m = command.moving_mass_m;
  state.volume_m3 = command.volume_m3;
  return state;
}

/// Numbers, and none that no vehicle has.
bool is_believable(const VehicleState<double>& state) {
  constexpr double fastest_m_s = 100, fastest_rad_s = 100;
  const Spatial<double>& nu = state.body.nu;
  return doubt_of(state) == 0 && length_of(nu.linear) <= fastest_m_s &&
         length_of(nu.angular) <= fastest_rad_s;
}

void note_row(const Trial& trial, const BodyState<double>& body, double first_down_m,
              TrialRun& run) {
  const double counts_from_m = first_of(trial, TrialQuantity::down).value_or(first_down_m);
  for (std::size_t i = 0; i < trial.measured.size(); ++i) {
    const TrialQuantity quantity = trial.measured[i].quantity;
    const double value = value_of(quantity, body);
    run.ours[i].push_back(quantity == TrialQuantity::down ? counts_from_m + (value - first_down_m)
                                                          : value);
  }
  ++run.rows;
}

}  // namespace

TrialRun replayed(const Vehicle& vehicle, const Trial& trial) {
  expect_replayable(vehicle, trial);
  const double voltage_v = usual_voltage_v(vehicle);
  VehicleState<double> state = first_state_of(vehicle, trial, voltage_v);
  const double first_down_m = state.body.position_m.z;
  Surroundings<double> around;
  around.water.velocity_m_s = trial.current_m_s;
  TrialRun run;
  run.ours.resize(trial.measured.size());
  for (std::vector<double>& ours : run.ours) ours.reserve(trial.rows());
  run.ended_at_s = trial.time_s.front();
  if (!is_believable(state)) return run;
  note_row(trial, state.body, first_down_m, run);
  for (std::size_t row = 0; row + 1 < trial.rows(); ++row) {
    const double gap_s = trial.time_s[row + 1] - trial.time_s[row];
    // A hair over a whole number of steps is the rounding of clocks.
    const double steps = std::max(1.0, std::ceil(gap_s / vehicle.largest_step_s - 1e-9));
    const StepPlan plan =
        plan_step(vehicle, std::min(gap_s / steps, vehicle.largest_step_s), voltage_v);
    const VehicleCommand<double> command = command_in(vehicle, trial, row, state);
    for (double i = 0; i < steps; ++i) {
      around.height_above_m = height_of(state.body.position_m);
      step(vehicle, plan, state, command, around);
      if (!is_believable(state)) {
        run.ended_at_s = trial.time_s[row] + (i + 1) * plan.dt_s;
        return run;
      }
    }
    note_row(trial, state.body, first_down_m, run);
    run.ended_at_s = trial.time_s[row + 1];
  }
  return run;
}

}  // namespace slackwater::twin
