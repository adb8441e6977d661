#pragma once
#include <optional>
#include <string>

#include <Eigen/Core>

#include "twin/vehicle/vehicle.h"

namespace slackwater::twin {

/// How a vehicle goes with nobody at its controls: straight and level at its cruise speed through
/// still water, what holds it there held (thrust, ballast), fins amidships. Of what swims and what
/// floats; a multirotor has no such way.
struct OpenLoop {
  double speed_m_s = 0;
  double pitch_per_s = 0;  ///< growth rate of the mode of pitch that grows fastest; 0: none does
  double yaw_per_s = 0;    ///< the same, of yaw
  double roll_per_s = 0;
  // By the motion itself, from a degree off that way.
  bool goes_over = false;        ///< rolls or pitches beyond a right angle
  double largest_pitch_rad = 0;  ///< of its size
  double turn_rad_s = 0;         ///< at the end, of its size
  /// With all that pushes ahead, where it goes over at that speed and not at its cruise.
  std::optional<double> over_at_m_s;
  [[nodiscard]] bool is_stable() const noexcept {
    return !(pitch_per_s > 0 || yaw_per_s > 0 || roll_per_s > 0);
  }
};

/// The state that is looked at, as it differs from that way: depth m, roll, pitch rad, u v w m/s,
/// p q r rad/s.
inline constexpr int open_loop_states = 9;
using OpenLoopMatrix = Eigen::Matrix<double, open_loop_states, open_loop_states>;

/// The slopes of the state's rates on the state, of the same equations that the step solves, by
/// central differences. A growth rate is the real part of an eigenvalue; its mode is of the turning
/// (pitch, yaw, roll) that has the largest part in its eigenvector. Source: Fossen (2011), 7.5.
[[nodiscard]] OpenLoopMatrix open_loop_matrix(const Vehicle& vehicle, double speed_m_s);

/// Growth slower than e-fold in ten minutes is none: nobody leaves the controls for so long.
/// Cost: some milliseconds, where something grows.
[[nodiscard]] OpenLoop open_loop_of(const Vehicle& vehicle);

/// That it somersaults, pitches, circles or rolls over without a controller, how fast that grows
/// and what to do; empty for one that is stable.
[[nodiscard]] std::string words_of(const OpenLoop& open_loop);

}  // namespace slackwater::twin
