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
  double yaw_rate_rad_s = 0;    ///< of the way itself, where it bends
  bool is_over_ground = false;  ///< `ahead_m_s` is what the bow makes over ground
};

/// The heading that takes a craft of that speed through the water along a course over ground: it
/// leads by asin(U_c,across/U), Fossen (2011), 12.3; square to the course where the water is faster
/// than that.
[[nodiscard]] Course crabbing(const Course& course, double speed_m_s,
                              const Triple<double>& water_m_s) noexcept;

/// The heading of a craft that makes that speed over ground along a course: it leads by
/// atan(U_c,across/U), however fast it must go through the water for that.
[[nodiscard]] Course crabbing_over_ground(const Course& course, double speed_m_s,
                                          const Triple<double>& water_m_s) noexcept;

/// Along a path of craft that must point where they go: at the reference's speed through the water,
/// or over ground where it says so, in what they know of the current and have learned of their
/// drift. The course over ground leans towards the path as a line of sight does whose lookahead is
/// U / station_per_s.
[[nodiscard]] Way way_along(const Autopilot& autopilot, const Measured& measured,
                            const Reference& reference, const Triple<double>& wanted_m_s,
                            const Outset& outset, double dt_s, ControlState& state) noexcept;

/// Speed ahead of craft that must point where they go.
struct AheadLoop {
  double through_m_s = 0;  ///< through the water, as well as it is known
  double lacking_m_s = 0;  ///< of the speed that the loop holds
};
/// Eases the speed asked for towards that of the way, and compares. Through the water without a log
/// nothing is known to be lacking: the thrust is that of the speed in still water, which is how a
/// propeller is calibrated.
[[nodiscard]] AheadLoop ahead_loop(const Autopilot& autopilot, const Measured& measured,
                                   const Way& way, double dt_s, ControlState& state) noexcept;
/// The push ahead that this takes, N. Over ground it is held at no less than what keeps a way on:
/// water that is faster than the speed asked for is no reason to go astern.
[[nodiscard]] double push_ahead_n(const Autopilot& autopilot, const Way& way, double push_m_s2,
                                  const ControlState& state) noexcept;

/// Resistance at a velocity through the water, body axes, without the shear.
[[nodiscard]] Spatial<double> resistance(const Autopilot& autopilot,
                                         const Spatial<double>& nu_r) noexcept;

}  // namespace slackwater::twin
