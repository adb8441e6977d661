#include "twin/navigation/sensor_suite.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "fields/base/error.h"
#include "fields/base/turn.h"
#include "twin/navigation/turn.h"

namespace slackwater::twin {
namespace {

std::uint64_t every_of(double rate_hz, double dt_s) {
  return static_cast<std::uint64_t>(std::max(1.0, std::round(1 / (rate_hz * dt_s))));
}

}  // namespace

SensorSuite plan_instruments(const Sensors& sensors, double dt_s, bool is_dry) {
  const char* missing = !sensors.imu ? "imu" : !sensors.compass ? "compass" : nullptr;
  if (missing != nullptr) {
    throw Error(ErrorKind::invalid_input, std::string("its file has no sensors: ") + missing +
                                              ", without which it knows no heading; add one, or "
                                              "give it navigation: truth");
  }
  SensorSuite out;
  out.sensors = sensors;
  out.dt_s = dt_s;
  if (sensors.gnss) out.gnss_every = every_of(sensors.gnss->rate_hz, dt_s);
  if (sensors.depth) out.depth_every = every_of(sensors.depth->rate_hz, dt_s);
  if (sensors.compass) out.compass_every = every_of(sensors.compass->rate_hz, dt_s);
  if (sensors.dvl) out.dvl_every = every_of(sensors.dvl->rate_hz, dt_s);
  out.is_dry = is_dry;
  return out;
}

InstrumentState started(const SensorSuite& instruments, std::uint64_t seed,
                        std::string_view vehicle, const BodyState<double>& body) {
  const auto stream = [&](const char* instrument) {
    return NoiseStream(seed, "twin/" + std::string(instrument) + "/" + std::string(vehicle));
  };
  const Sensors& sensors = instruments.sensors;
  InstrumentState state;
  state.imu = started(*sensors.imu, stream("imu"));
  if (sensors.gnss) state.gnss = started(*sensors.gnss, stream("gnss"));
  state.depth = stream("depth");
  state.compass = stream("compass");
  state.dvl = stream("dvl");
  state.velocity_before_m_s = rotation_of(body.attitude).to_ned(body.nu.linear);
  state.attitude_before = body.attitude;
  return state;
}

ImuReading at_rest(const SensorSuite& instruments, InstrumentState& state,
                   const BodyState<double>& body, double for_s) noexcept {
  return measured(*instruments.sensors.imu, state.imu, rotation_of(body.attitude), {}, {}, for_s);
}

double heading_at_rest_rad(const SensorSuite& instruments, InstrumentState& state,
                           const BodyState<double>& body, double for_s) noexcept {
  const double heading_rad = euler_angles(body.attitude).yaw_rad;
  const Compass& compass = *instruments.sensors.compass;
  const int readings = std::max(1, static_cast<int>(for_s * compass.rate_hz));
  double off_rad = 0;
  for (int i = 0; i < readings; ++i)
    off_rad += wrapped_rad(measured_heading_rad(compass, state.compass, heading_rad) - heading_rad);
  return heading_rad + off_rad / readings;
}

Felt feel(const SensorSuite& instruments, InstrumentState& state,
          const BodyState<double>& body) noexcept {
  const double dt_s = instruments.dt_s;
  const Rotation<double> r = rotation_of(body.attitude);
  const Triple<double> velocity_m_s = r.to_ned(body.nu.linear);
  const Triple<double> turn_rad_s = (1 / dt_s) * turn_between(state.attitude_before, body.attitude);
  const Triple<double> acceleration_m_s2 = (1 / dt_s) * (velocity_m_s - state.velocity_before_m_s);
  Felt felt;
  felt.mean = measured(*instruments.sensors.imu, state.imu, r, turn_rad_s, acceleration_m_s2, dt_s);
  felt.turn_rate_now_rad_s = felt.mean.turn_rate_rad_s + (body.nu.angular - turn_rad_s);
  state.velocity_before_m_s = velocity_m_s;
  state.attitude_before = body.attitude;
  state.shown.turn_rate_rad_s = felt.turn_rate_now_rad_s;
  state.shown.specific_force_m_s2 = felt.mean.specific_force_m_s2;
  return felt;
}

}  // namespace slackwater::twin
