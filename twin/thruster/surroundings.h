#pragma once

namespace slackwater::twin {

/// What a thruster meets.
template <typename Real>
struct ThrusterSurroundings {
  /// Of the vehicle through the fluid there, along the direction of positive thrust.
  Real advance_m_s{};
  Real across_m_s{};  ///< its speed across that direction, not negative
  Real voltage_v{};   ///< of the bus
  Real height_m{};    ///< above what a rotor's wash meets
};

/// What a thruster does.
template <typename Real>
struct ThrusterOutput {
  Real thrust_n{};
  /// Of the propeller on the fluid, about the direction of thrust and the way it turns.
  Real torque_n_m{};
  Real power_w{};     ///< drawn from the bus
  Real fuel_kg_s{};   ///< burnt
  Real drag_n_s_m{};  ///< force against motion across the thrust, per speed
};

/// The share of its full speed that a motor reaches on a sagging bus: with permanent magnets the
/// speed it can turn at goes with the voltage.
/// @param full_speed_voltage_v  from which on it reaches all; 0: always
template <typename Real>
[[nodiscard]] Real speed_share(double full_speed_voltage_v, const Real& voltage_v) {
  const double per_volt = full_speed_voltage_v > 0 ? 1 / full_speed_voltage_v : 0;
  const Real full = Real{} + (full_speed_voltage_v > 0 ? 0.0 : 1.0);
  return smaller_of(larger_of(per_volt * voltage_v + full, Real{} + 0.0), Real{} + 1.0);
}

/// A command within what is possible.
template <typename Real>
[[nodiscard]] Real within(const Real& value, const Real& low, const Real& high) {
  return smaller_of(larger_of(value, low), high);
}

}  // namespace slackwater::twin
