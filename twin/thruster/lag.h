#pragma once
#include "fields/base/numbers/real.h"

namespace slackwater::twin {

/// What a step of a given length needs of a first-order lag, T x' = command - x, worked out once.
/// What rises has one time constant, what falls another.
struct LagStep {
  double rise_left = 0;  ///< of the distance to the command, after the step: e^(-dt/T)
  double fall_left = 0;
  double rise_left_mean = 0;  ///< meant over the step
  double fall_left_mean = 0;
};
/// @param rise_s, fall_s  time constants; 0: at once
[[nodiscard]] LagStep lag_step(double rise_s, double fall_s, double dt_s);

template <typename Real>
struct Lagged {
  Real mean{};  ///< over the step
  Real end{};
};

/// The exact solution over a step with the command held.
template <typename Real>
[[nodiscard]] Lagged<Real> lagged(const LagStep& step, const Real& value, const Real& command) {
  const Real gap = value - command;
  const auto rises = gap < 0.0;
  const Real left = select(rises, Real{} + step.rise_left, Real{} + step.fall_left);
  const Real left_mean = select(rises, Real{} + step.rise_left_mean, Real{} + step.fall_left_mean);
  return {command + left_mean * gap, command + left * gap};
}

}  // namespace slackwater::twin
