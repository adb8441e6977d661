#include "twin/navigation/navigator.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/turn.h"
#include "twin/navigation/turn.h"

namespace slackwater::twin {
namespace {

constexpr double gravity = constants::gravity_m_s2;

/// Turns what is taken for level and north. @param turn_rad  NED
void turn(NavigatorState& state, const Triple<double>& turn_rad) noexcept {
  state.attitude = turned(state.attitude, rotation_of(state.attitude).to_body(turn_rad));
}

/// A turn that keeps being needed is a bias of the gyro.
void blame_gyro(NavigatorState& state, const Triple<double>& rate_rad_s) noexcept {
  state.gyro_bias_rad_s = state.gyro_bias_rad_s - rotation_of(state.attitude).to_body(rate_rad_s);
}

/// The turn that a velocity error speaks of: (north, east) too fast by what it is tilted by east
/// and north.
Triple<double> tilt_of(const Triple<double>& velocity_error_m_s) noexcept {
  return (1 / gravity) * Triple<double>{velocity_error_m_s.y, -velocity_error_m_s.x, 0};
}

}  // namespace

NavigatorState aligned(const Triple<double>& position_m, const ImuReading& at_rest,
                       double heading_rad) noexcept {
  const Triple<double>& f = at_rest.specific_force_m_s2;
  NavigatorState state;
  state.position_m = position_m;
  state.attitude =
      attitude_of({std::atan2(-f.y, -f.z), std::atan2(f.x, std::hypot(f.y, f.z)), heading_rad});
  state.gyro_bias_rad_s = at_rest.turn_rate_rad_s;
  state.accelerometer_bias_down_m_s2 = gravity - std::sqrt(dot(f, f));
  return state;
}

void reckon(const Navigator& navigator, NavigatorState& state, const ImuReading& mean,
            const Triple<double>& turn_rate_now_rad_s, double dt_s) noexcept {
  state.attitude = turned(state.attitude, dt_s * (mean.turn_rate_rad_s - state.gyro_bias_rad_s));
  state.turn_rate_rad_s = turn_rate_now_rad_s - state.gyro_bias_rad_s;
  const Rotation<double> r = rotation_of(state.attitude);
  const Triple<double> force_m_s2 =
      mean.specific_force_m_s2 - Triple<double>{0, 0, state.accelerometer_bias_down_m_s2};
  const Triple<double> before_m_s = state.velocity_m_s;
  state.velocity_m_s = before_m_s + dt_s * (r.to_ned(force_m_s2) + Triple<double>{0, 0, gravity});
  state.position_m = state.position_m + (0.5 * dt_s) * (before_m_s + state.velocity_m_s);
  state.unaided_s += dt_s;
  if (state.unaided_s <= navigator.patience_s) return;
  const double k = navigator.velocity_per_s;
  const Triple<double> error_m_s{-state.velocity_m_s.x, -state.velocity_m_s.y, 0};
  turn(state, (3 * k * k * dt_s) * tilt_of(error_m_s));
  state.velocity_m_s = state.velocity_m_s + std::min(3 * k * dt_s, 1.0) * error_m_s;
}

void take_velocity(const Navigator& navigator, NavigatorState& state,
                   const Triple<double>& velocity_m_s, double interval_s) noexcept {
  const double k = navigator.velocity_per_s;
  const Triple<double> error_m_s = velocity_m_s - state.velocity_m_s;
  const double down = rotation_of(state.attitude).down.z;
  turn(state, (3 * k * k * interval_s) * tilt_of(error_m_s));
  blame_gyro(state, (k * k * k * interval_s) * tilt_of(error_m_s));
  state.accelerometer_bias_down_m_s2 -= k * k * interval_s * down * error_m_s.z;
  state.velocity_m_s = state.velocity_m_s + std::min(3 * k * interval_s, 1.0) * error_m_s;
  state.unaided_s = 0;
}

void take_heading(const Navigator& navigator, NavigatorState& state, double heading_rad,
                  double interval_s) noexcept {
  const double k = navigator.heading_per_s;
  const Rotation<double> r = rotation_of(state.attitude);
  const double error_rad = wrapped_rad(heading_rad - std::atan2(r.east.x, r.north.x));
  turn(state, {0, 0, std::min(2 * k * interval_s, 1.0) * error_rad});
  blame_gyro(state, {0, 0, k * k * interval_s * error_rad});
}

void take_depth(const Navigator& navigator, NavigatorState& state, double depth_m,
                double interval_s) noexcept {
  const double k = navigator.depth_per_s;
  const double error_m = depth_m - state.position_m.z;
  const double down = rotation_of(state.attitude).down.z;
  state.accelerometer_bias_down_m_s2 -= k * k * k * interval_s * down * error_m;
  state.velocity_m_s.z += 3 * k * k * interval_s * error_m;
  state.position_m.z += std::min(3 * k * interval_s, 1.0) * error_m;
}

void take_position(const Navigator& navigator, NavigatorState& state,
                   const Triple<double>& position_m, double interval_s) noexcept {
  const double share = std::min(navigator.position_per_s * interval_s, 1.0);
  state.position_m.x += share * (position_m.x - state.position_m.x);
  state.position_m.y += share * (position_m.y - state.position_m.y);
  if (!navigator.has_depth) state.position_m.z += share * (position_m.z - state.position_m.z);
}

Measured measured_of(const NavigatorState& state) noexcept {
  Measured measured;
  measured.position_m = state.position_m;
  measured.attitude = state.attitude;
  measured.nu.linear = rotation_of(state.attitude).to_body(state.velocity_m_s);
  measured.nu.angular = state.turn_rate_rad_s;
  return measured;
}

}  // namespace slackwater::twin
