#pragma once
#include "twin/battery/battery_step.h"

namespace slackwater::tests {

/// A pack of 15.2 V whatever its charge, unless told otherwise, of 18 Ah, 28 mOhm and 10 mOhm
/// beside 3000 F.
[[nodiscard]] inline twin::Battery made_up_battery(double empty_v = 15.2, double full_v = 15.2) {
  twin::Battery battery;
  battery.state_of_charge = {0, 0.25, 5};
  for (std::size_t i = 0; i < 5; ++i) {
    battery.open_circuit_v.push_back(empty_v + (full_v - empty_v) * battery.state_of_charge.at(i));
  }
  battery.capacity_c = 18 * 3600;
  battery.resistance_ohm = 0.028;
  battery.rc_resistance_ohm = 0.010;
  battery.rc_capacitance_f = 3000;
  battery.most_current_a = 1e4;
  battery.least_voltage_v = 0.5;
  battery.cut_off_delay_s = 10;
  return battery;
}

}  // namespace slackwater::tests
