#pragma once
#include "twin/control/reference.h"
#include "twin/sensor/imu.h"

namespace slackwater::twin {

/// What a vehicle makes of its instruments: where it is, how it lies and how fast it goes. A
/// strapdown reckoning with fixed gains, which is a complementary filter: the fast comes from the
/// IMU, the slow from what does not drift.
///
///   q' = q (w - b) / 2,   v' = R (f - c) + g,   p' = v
///
/// w turn rate and f specific force as measured, b and c what is known of their biases. Each other
/// instrument draws the state towards what it shows, per second of its interval:
///
/// | shows             | draws                                       | poles                      |
/// |-------------------|---------------------------------------------|----------------------------|
/// | velocity (1)      | v; the tilt by (error x down)/g, and b      | three at `velocity_per_s`, |
/// |                   | with it; downwards v, c                     | downwards 0.4 and 2.6 of it|
/// | heading (compass) | q about the vertical, and b                 | two at `heading_per_s`     |
/// | depth             | downwards p, v and c                        | three at `depth_per_s`     |
/// | position (GNSS)   | p; downwards only without a depth sensor    | one at `position_per_s`    |
///
/// (1) of GNSS or DVL.
///
/// That a velocity error speaks of tilt is gravity's doing: a tilt of d looks like an acceleration
/// of g d (Farrell, Aided Navigation (2008), 11; Mahony, Hamel and Pflimlin, IEEE Trans. Autom.
/// Control 53 (2008), for the filter of attitude).
///
/// What follows for a vehicle without fixes. A heading that is wrong by h carries it aside by h of
/// the way made, a scale that is wrong by s along by s of it; white noise n of each reading of
/// velocity, every T, walks it by n sqrt(T t); a track through the water drifts with the water.
/// Nothing draws that back until the next fix.
struct Navigator {
  double velocity_per_s = 0.3;
  double heading_per_s = 0.2;
  double depth_per_s = 0.05;
  double position_per_s = 0.2;
  /// A vehicle that is told no velocity for this long takes itself to be still: its tilt is
  /// levelled and nothing runs away.
  double patience_s = 5;
  bool has_depth = false;
};

/// Numbers only: copied for a checkpoint.
struct NavigatorState {
  Triple<double> position_m;    ///< NED
  Triple<double> velocity_m_s;  ///< over ground, NED
  Attitude<double> attitude;
  Triple<double> turn_rate_rad_s;  ///< body axes
  Triple<double> gyro_bias_rad_s;
  double accelerometer_bias_down_m_s2 = 0;  ///< along the body's z
  double unaided_s = 0;                     ///< since the last velocity
};

/// What it knows before it moves: how it lies, from the mean of an IMU at rest and the compass; the
/// bias of its gyro.
[[nodiscard]] NavigatorState aligned(const Triple<double>& position_m, const ImuReading& at_rest,
                                     double heading_rad) noexcept;

/// Moves the reckoning on by the mean reading of the last `dt_s`, and levels it where no velocity
/// has come for long.
/// @param turn_rate_now_rad_s  the gyro's last sample, for what damps turns
void reckon(const Navigator& navigator, NavigatorState& state, const ImuReading& mean,
            const Triple<double>& turn_rate_now_rad_s, double dt_s) noexcept;

// What the other instruments show; `interval_s` is the time since they last spoke.
/// @param velocity_m_s  over ground, NED
void take_velocity(const Navigator& navigator, NavigatorState& state,
                   const Triple<double>& velocity_m_s, double interval_s) noexcept;
void take_heading(const Navigator& navigator, NavigatorState& state, double heading_rad,
                  double interval_s) noexcept;
void take_depth(const Navigator& navigator, NavigatorState& state, double depth_m,
                double interval_s) noexcept;
/// @param position_m  NED
void take_position(const Navigator& navigator, NavigatorState& state,
                   const Triple<double>& position_m, double interval_s) noexcept;

/// What autopilot and guidance get of it.
[[nodiscard]] Measured measured_of(const NavigatorState& state) noexcept;

}  // namespace slackwater::twin
