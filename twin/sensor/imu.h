#pragma once
#include "twin/sensor/noise.h"

namespace slackwater::twin {

/// One kind of inertial sensor, three axes: white noise of a density N, and a bias that starts
/// somewhere and walks with a density K. Its Allan variance is N^2/t + K^2 t/3 (IEEE Std 952-1997,
/// annex C).
struct InertialNoise {
  double white_density = 0;  ///< N: rad/s or m/s2, per root hertz
  double walk_density = 0;   ///< K: rad/s or m/s2, per root second
  double start_bias_sd = 0;
  double range = 0;  ///< clipped beyond
};

/// Gyroscopes and accelerometers of the tactical-to-consumer kind of small vehicles. Numbers of the
/// kind of a ICM-20689 (datasheet: 0.006 deg/s and 150 ug per root hertz); walk and start are
/// estimates.
struct Imu {
  InertialNoise gyro{1.05e-4, 4e-6, 2e-3, 34.9};
  InertialNoise accelerometer{1.47e-3, 1e-4, 0.05, 157};
};

struct ImuState {
  NoiseStream noise;
  Triple<double> gyro_bias_rad_s;
  Triple<double> accelerometer_bias_m_s2;
};
[[nodiscard]] ImuState started(const Imu& imu, const NoiseStream& noise) noexcept;

struct ImuReading {
  Triple<double> turn_rate_rad_s;      ///< body axes
  Triple<double> specific_force_m_s2;  ///< body axes: (0, 0, -g) at rest and level
};

/// What an accelerometer feels: acceleration less gravity, R^T (a - g), body axes.
[[nodiscard]] Triple<double> specific_force_m_s2(
    const Rotation<double>& r, const Triple<double>& acceleration_ned_m_s2) noexcept;

/// The mean over the last `dt_s` of a body that turns and accelerates evenly.
[[nodiscard]] ImuReading measured(const Imu& imu, ImuState& state, const Rotation<double>& r,
                                  const Triple<double>& turn_rate_rad_s,
                                  const Triple<double>& acceleration_ned_m_s2,
                                  double dt_s) noexcept;

}  // namespace slackwater::twin
