#pragma once
#include <algorithm>

namespace slackwater::twin {

/// Gains of a controller whose output is bounded. The integral stops where the output is at its
/// bound and the error would push it further (clamping), so that it does not wind up.
struct Pid {
  double proportional = 0;
  double integral = 0;
  double derivative = 0;
  double most = 1e9;  ///< of the output, either way
};

struct PidState {
  double integral = 0;  ///< of the error over time
};

/// One step. `rate` is how fast the error changes; measured, not differenced, where it can be.
[[nodiscard]] inline double output_of(const Pid& pid, PidState& state, double error, double rate,
                                      double dt_s) {
  const double grown = state.integral + error * dt_s;
  const double wanted = pid.proportional * error + pid.integral * grown + pid.derivative * rate;
  const double bounded = std::clamp(wanted, -pid.most, pid.most);
  const bool is_winding_up = wanted != bounded && wanted * error > 0;
  if (!is_winding_up) state.integral = grown;
  return bounded;
}

}  // namespace slackwater::twin
