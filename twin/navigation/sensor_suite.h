#pragma once

#include "fields/base/constants.h"
#include "twin/body/body.h"
#include "twin/sensor/read_sensors.h"

namespace slackwater::twin {

/// A number that an instrument did not give.
inline constexpr double nothing_shown = constants::nan;

/// The instruments of a vehicle that it navigates by, and after how many steps each speaks again;
/// 0: it has none.
struct SensorSuite {
  Sensors sensors;
  double dt_s = 0;
  std::uint64_t gnss_every = 0;
  std::uint64_t depth_every = 0;
  std::uint64_t compass_every = 0;
  std::uint64_t dvl_every = 0;
  bool is_dry = false;  ///< the antenna of what flies or floats never gets under water
};
/// @throws Error(invalid_input) for a vehicle that lacks an IMU or a compass
[[nodiscard]] SensorSuite plan_instruments(const Sensors& sensors, double dt_s, bool is_dry);

/// What the instruments showed last; NaN where the last time they gave nothing.
struct Shown {
  Triple<double> turn_rate_rad_s;                                               ///< body axes
  Triple<double> specific_force_m_s2;                                           ///< body axes
  Triple<double> gnss_position_m{nothing_shown, nothing_shown, nothing_shown};  ///< NED
  Triple<double> gnss_velocity_m_s{nothing_shown, nothing_shown, nothing_shown};
  double depth_m = nothing_shown;
  double heading_rad = nothing_shown;
  Triple<double> dvl_velocity_m_s{nothing_shown, nothing_shown, nothing_shown};  ///< body axes
  double dvl_is_bottom = 0;  ///< 1: against the bed, 0: against the water
  double dvl_altitude_m = nothing_shown;
  double dvl_ahead_m_s = nothing_shown;  ///< through the water
};

/// All that changes in them; a value, copied for a checkpoint.
struct InstrumentState {
  ImuState imu;
  GnssState gnss;
  NoiseStream depth;
  NoiseStream compass;
  NoiseStream dvl;
  std::uint64_t steps = 0;
  /// As they were a step ago: what an IMU feels lies between.
  Triple<double> velocity_before_m_s;
  Attitude<double> attitude_before;
  Shown shown;
};
/// Each instrument has its own noise, of (seed, vehicle, instrument).
[[nodiscard]] InstrumentState started(const SensorSuite& instruments, std::uint64_t seed,
                                      std::string_view vehicle, const BodyState<double>& body);

/// An instrument that speaks in this step.
[[nodiscard]] inline bool is_due(std::uint64_t every, const InstrumentState& state) noexcept {
  return every > 0 && state.steps % every == 0;
}

/// The mean of an IMU over `for_s` at rest, before the vehicle moves.
[[nodiscard]] ImuReading at_rest(const SensorSuite& instruments, InstrumentState& state,
                                 const BodyState<double>& body, double for_s) noexcept;
/// The mean of a compass over `for_s` at rest.
[[nodiscard]] double heading_at_rest_rad(const SensorSuite& instruments, InstrumentState& state,
                                         const BodyState<double>& body, double for_s) noexcept;

/// What an IMU felt since the last step.
struct Felt {
  ImuReading mean;                     ///< of the step
  Triple<double> turn_rate_now_rad_s;  ///< of its last sample: a gyro has hundreds in a step
};
[[nodiscard]] Felt feel(const SensorSuite& instruments, InstrumentState& state,
                        const BodyState<double>& body) noexcept;

}  // namespace slackwater::twin
