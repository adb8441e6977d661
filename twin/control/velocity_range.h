#pragma once
#include "twin/control/autopilot.h"

namespace slackwater::twin {

/// The velocities that an autopilot can be asked for at all: through the water, of those that fly
/// over ground; in axes of the heading. Bounds of settings and kind; that the vehicle reaches them
/// is not said.
struct VelocityRange {
  double least_ahead_m_s = 0;  ///< astern: negative; an AUV goes ahead alone
  double most_ahead_m_s = 0;
  double most_sideways_m_s = 0;  ///< either way; 0: it cannot push there
  double most_along_m_s = 0;     ///< ahead and sideways together
  double most_up_m_s = 0;        ///< 0: it floats
  double most_down_m_s = 0;
  double most_turn_rad_s = 0;  ///< either way
};
[[nodiscard]] VelocityRange velocity_range(const Autopilot& autopilot) noexcept;

}  // namespace slackwater::twin
