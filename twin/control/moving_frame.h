#pragma once
#include "twin/control/autopilot.h"

namespace slackwater::twin {

/// A frame that is carried over ground without turning: what drifts with it rests in it. Zero: the
/// ground itself.
struct MovingFrame {
  Triple<double> offset_m;      ///< of its origin from that of the ground, NED, now
  Triple<double> velocity_m_s;  ///< of it over ground
};

/// What the vehicle knows, as seen from the frame. What it makes through the water stays what it
/// is.
/// @param knows_water  it is told of the current
[[nodiscard]] Measured seen_from(const MovingFrame& frame, const Measured& measured,
                                 bool knows_water) noexcept;
/// What is asked for in the frame, over ground.
[[nodiscard]] Reference over_ground(const MovingFrame& frame, const Reference& reference) noexcept;

/// Lets an autopilot go on in a frame that is `faster_m_s` faster than the one it was in: the
/// velocities that it remembers are of that frame.
/// @param knows_water  then what it has learned of its drift is besides the current, and stays
void change_frame(const Triple<double>& faster_m_s, bool knows_water, ControlState& state) noexcept;

}  // namespace slackwater::twin
