#include "twin/battery/lasts.h"

#include <algorithm>

#include "fields/base/check.h"
#include "twin/battery/battery_step.h"

namespace slackwater::twin {

double lasts_s(const Battery& battery, double power_w) {
  expects(power_w > 0, "a load draws something");
  // A thousand steps of what the energy of its source lasts at that power, and of 1 s at least.
  constexpr double longest_s = 1e8, steps = 1000;
  const double at_most_s = open_circuit_energy_j(battery, 1, 0) / power_w;
  const double dt_s = std::clamp(at_most_s / steps, 1.0, longest_s / steps);
  const BatteryStep step = battery_step(battery, dt_s);
  BatteryState<double> state = rested(battery, 1);
  double t_s = 0;
  for (; t_s < longest_s; t_s += dt_s) {
    const BatteryOutput<double> out = discharge(battery, step, state, power_w);
    if (state.off > 0.5 || out.curtailed > 0.5) break;
  }
  return std::min(t_s, longest_s);
}

}  // namespace slackwater::twin
