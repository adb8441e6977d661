#pragma once
#include "twin/control/autopilot.h"

// The laws behind `effort_of`, one per way to be moved. What they are given is finite.
namespace slackwater::twin {

/// What every law begins with.
struct Outset {
  Rotation<double> r;
  Triple<double> velocity_m_s;  ///< over ground, NED
  Course bow;
  double too_shallow_m = 0;  ///< what is lacking downwards
};

/// A craft that pushes along both horizontal axes: an ROV, a vessel with tunnel thrusters.
[[nodiscard]] Effort steer_free(const Autopilot& autopilot, const Measured& measured,
                                const Reference& reference, const Outset& outset, double dt_s,
                                ControlState& state) noexcept;
/// A surface craft that drives and turns, and cannot push sideways.
[[nodiscard]] Effort steer_by_turning(const Autopilot& autopilot, const Measured& measured,
                                      const Reference& reference, const Outset& outset, double dt_s,
                                      ControlState& state) noexcept;
/// A torpedo: a propeller and fins.
[[nodiscard]] Effort steer_by_fins(const Autopilot& autopilot, const Measured& measured,
                                   const Reference& reference, const Outset& outset, double dt_s,
                                   ControlState& state) noexcept;
[[nodiscard]] Effort steer_by_tilt(const Autopilot& autopilot, const Measured& measured,
                                   const Reference& reference, const Outset& outset, double dt_s,
                                   ControlState& state) noexcept;

/// Moves the velocity asked for towards `wanted`, by no more than the accelerations allowed.
[[nodiscard]] Triple<double> eased_velocity(const Autopilot& autopilot,
                                            const Triple<double>& wanted_m_s, double dt_s,
                                            ControlState& state) noexcept;
/// The velocity over ground that the reference asks for, NED, within the limits of speed.
[[nodiscard]] Triple<double> wanted_velocity(const Autopilot& autopilot, const Measured& measured,
                                             const Reference& reference,
                                             const Outset& outset) noexcept;

/// Where to point the bow and how fast to go through the water.
struct Way {
  Course heading;
  double ahead_m_s = 0;
  double yaw_rate_rad_s = 0;  ///< of the way itself, where it bends
};

/// The heading that takes a craft of that speed through the water along a course over ground: it
/// leads by asin(U_c,across/U), Fossen (2011), 12.3; square to the course where the water is faster
/// than that.
[[nodiscard]] Course crabbing(const Course& course, double speed_m_s,
                              const Triple<double>& water_m_s) noexcept;

/// Along a path of craft that must point where they go: at the reference's speed through the water,
/// in what they know of the current and have learned of their drift. The course over ground leans
/// towards the path as a line of sight does whose lookahead is U / station_per_s.
[[nodiscard]] Way way_along(const Autopilot& autopilot, const Measured& measured,
                            const Reference& reference, const Triple<double>& wanted_m_s,
                            const Outset& outset, double dt_s, ControlState& state) noexcept;

/// Resistance at a velocity through the water, body axes, without the shear.
[[nodiscard]] Spatial<double> resistance(const Autopilot& autopilot,
                                         const Spatial<double>& nu_r) noexcept;

}  // namespace slackwater::twin
