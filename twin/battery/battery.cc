#include "twin/battery/battery.h"

#include <cmath>

#include "fields/base/check.h"
#include "twin/battery/battery_step.h"

namespace slackwater::twin {

BatteryStep battery_step(const Battery& battery, double dt_s) {
  expects(dt_s > 0, "a step of a battery takes time");
  BatteryStep step;
  step.dt_s = dt_s;
  const double time_constant_s = battery.rc_resistance_ohm * battery.rc_capacitance_f;
  if (time_constant_s > 0) {
    step.rc_left = std::exp(-dt_s / time_constant_s);
    step.rc_left_mean = -std::expm1(-dt_s / time_constant_s) * (time_constant_s / dt_s);
  }
  step.charge_per_a = dt_s / battery.capacity_c;
  return step;
}

BatteryState<double> rested(const Battery& battery, double state_of_charge) {
  expects(state_of_charge >= 0 && state_of_charge <= 1, "a state of charge is from 0 to 1");
  BatteryState<double> state;
  state.charge = state_of_charge;
  state.off = state_of_charge * battery.capacity_c > 0 ? 0 : 1;
  return state;
}

double rest_voltage_v(const Battery& battery, const BatteryState<double>& state) {
  return on_line(battery.open_circuit_v.data(), place_on(battery.state_of_charge, state.charge))
             .value -
         state.rc_voltage_v;
}

double open_circuit_energy_j(const Battery& battery, double from_charge, double to_charge) {
  const auto area_below = [&](double charge) {
    const PlaceOnAxis<double> place = place_on(battery.state_of_charge, charge);
    double area = 0;
    double at = 0;
    for (std::size_t i = 0; static_cast<double>(i) < place.below; ++i) {
      area += 0.5 * (battery.open_circuit_v[i] + battery.open_circuit_v[i + 1]);
      at = static_cast<double>(i + 1);
    }
    const double end = on_line(battery.open_circuit_v.data(), place).value;
    const double start = battery.open_circuit_v[static_cast<std::size_t>(at)];
    return (area + 0.5 * (start + end) * place.share) * battery.state_of_charge.step;
  };
  return battery.capacity_c * (area_below(from_charge) - area_below(to_charge));
}

}  // namespace slackwater::twin
