#pragma once
#include "twin/battery/battery.h"

namespace slackwater::twin {

/// What a step of a given length needs of a battery, worked out once.
struct BatteryStep {
  double dt_s = 0;
  double rc_left = 0;       ///< e^(-dt/(R1 C1)): what is left of V1 after the step without current
  double rc_left_mean = 0;  ///< the same, meant over the step
  double charge_per_a = 0;  ///< state of charge that one ampere takes: dt/Q
};
/// @throws ContractViolation for a step that is not positive
[[nodiscard]] BatteryStep battery_step(const Battery& battery, double dt_s);

/// What a battery gave during a step.
template <typename Real>
struct BatteryOutput {
  Real terminal_voltage_v{};  ///< mean over the step
  Real current_a{};           ///< held over the step
  Real power_w{};             ///< delivered, voltage times current
  Real curtailed{};           ///< 1: it could not give the whole load
};

/// One step under a load of constant power, load_w >= 0.
///
/// The current is held over the step, under which V1 and the state of charge move exactly; the
/// voltage that it meets is the mean over the step, V = V' - I R' with
///
///   V' = OCV(s) - V1 m,   R' = R0 + R1 (1 - m) + (dOCV/ds) dt/(2 Q),   m = mean of e^(-t/(R1 C1)),
///
/// so that power times time is the energy given, to second order in the step. P = I V has the roots
/// (V' -+ sqrt(V'^2 - 4 R' P))/(2 R'), of which the smaller is the one that the battery comes to
/// from rest; it is written 2 P/(V' + sqrt(...)), which loses no digits for a small load. What
/// exceeds V'^2/(4 R'), the current limit or the charge that is left is not given, and `curtailed`
/// says so.
///
/// Cost: a division or three, a square root. No allocation. For a step of zero length of an RC pair
/// without resistance these are the textbook formulae.
template <typename Real>
[[nodiscard]] BatteryOutput<Real> discharge(const Battery& battery, const BatteryStep& step,
                                            BatteryState<Real>& state, const Real& load_w) {
  const Real zero = Real{} + 0.0;
  const Real one = Real{} + 1.0;
  const OnLine<Real> open =
      on_line(battery.open_circuit_v.data(), place_on(battery.state_of_charge, state.charge));
  const double half_step =
      0.5 * step.charge_per_a * static_cast<double>(battery.state_of_charge.count - 1);
  const Real voltage_v = open.value - step.rc_left_mean * state.rc_voltage_v;
  const Real resistance_ohm =
      (battery.resistance_ohm + battery.rc_resistance_ohm * (1 - step.rc_left_mean)) +
      half_step * open.rise;
  const Real most_w = voltage_v * voltage_v / (4.0 * resistance_ohm);
  const Real wanted_w = smaller_of(load_w, most_w);
  const Real under_root = larger_of(voltage_v * voltage_v - 4.0 * resistance_ohm * wanted_w, zero);
  const Real wanted_a = 2.0 * wanted_w / (voltage_v + square_root(under_root));
  const Real most_a =
      smaller_of(state.charge * (1 / step.charge_per_a), Real{} + battery.most_current_a);
  const Real is_on = one - state.off;
  BatteryOutput<Real> out;
  out.current_a = is_on * smaller_of(wanted_a, most_a);
  out.terminal_voltage_v = voltage_v - resistance_ohm * out.current_a;
  out.power_w = out.terminal_voltage_v * out.current_a;
  out.curtailed = select(out.power_w < load_w * (1 - 1e-9), one, zero);

  state.rc_voltage_v = step.rc_left * state.rc_voltage_v +
                       (battery.rc_resistance_ohm * (1 - step.rc_left)) * out.current_a;
  state.charge = larger_of(state.charge - step.charge_per_a * out.current_a, zero);
  state.drawn_c = state.drawn_c + step.dt_s * out.current_a;
  state.delivered_j = state.delivered_j + step.dt_s * out.power_w;
  state.low_for_s = select(out.terminal_voltage_v < battery.least_voltage_v,
                           Real{state.low_for_s + step.dt_s}, zero);
  const Real cut = select(state.low_for_s > battery.cut_off_delay_s, one, zero);
  // The last step takes what is left but for its rounding.
  const Real empty = select(state.charge < 1e-12, one, zero);
  state.off = larger_of(state.off, larger_of(cut, empty));
  return out;
}

}  // namespace slackwater::twin
