#include "twin/sensor/imu.h"

#include <algorithm>

#include "fields/base/constants.h"

namespace slackwater::twin {
namespace {

Triple<double> sensed(const InertialNoise& kind, const Triple<double>& truth, Triple<double>& bias,
                      NoiseStream& noise, double dt_s) noexcept {
  bias = bias + (kind.walk_density * std::sqrt(dt_s)) * noise.normals();
  const Triple<double> v = truth + bias + (kind.white_density / std::sqrt(dt_s)) * noise.normals();
  const auto within = [&](double x) { return std::clamp(x, -kind.range, kind.range); };
  return {within(v.x), within(v.y), within(v.z)};
}

}  // namespace

ImuState started(const Imu& imu, const NoiseStream& noise) noexcept {
  ImuState state;
  state.noise = noise;
  state.gyro_bias_rad_s = imu.gyro.start_bias_sd * state.noise.normals();
  state.accelerometer_bias_m_s2 = imu.accelerometer.start_bias_sd * state.noise.normals();
  return state;
}

Triple<double> specific_force_m_s2(const Rotation<double>& r,
                                   const Triple<double>& acceleration_ned_m_s2) noexcept {
  return r.to_body(acceleration_ned_m_s2 - Triple<double>{0, 0, constants::gravity_m_s2});
}

ImuReading measured(const Imu& imu, ImuState& state, const Rotation<double>& r,
                    const Triple<double>& turn_rate_rad_s,
                    const Triple<double>& acceleration_ned_m_s2, double dt_s) noexcept {
  ImuReading reading;
  reading.turn_rate_rad_s =
      sensed(imu.gyro, turn_rate_rad_s, state.gyro_bias_rad_s, state.noise, dt_s);
  reading.specific_force_m_s2 =
      sensed(imu.accelerometer, specific_force_m_s2(r, acceleration_ned_m_s2),
             state.accelerometer_bias_m_s2, state.noise, dt_s);
  return reading;
}

}  // namespace slackwater::twin
