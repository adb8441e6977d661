#pragma once
#include "twin/clearance/clear_way.h"
#include "twin/control/autopilot.h"

namespace slackwater::twin {

/// How a vehicle of this autopilot gets out of trouble, from what its loops and thrusters do. All
/// estimates, checked in closed loop with the vehicles of data/vehicles:
///
/// - deceleration: half of the acceleration that its autopilot asks for, as that one brakes by half
///   of it too; surface craft all of it, but no more than half of their thrust astern gives;
/// - reaction: the lags of velocity loop and thrusters, 1/inner + tau, four times, so that it comes
///   to rest without going beyond (a second-order loop with its poles apart: t_r >= 4 tau), and a
///   step of the barrier; of surface craft twice, as they turn away besides;
/// - strays by what it accelerates within its lag, a tau^2; surface craft by half their radius;
/// - circle: that of its largest speed at four fifths of its largest rate of turn;
/// - sure speed: half of the largest.
///
/// @param radius_m, above_m, below_m  of the upright cylinder that it fills (see `Handling`)
[[nodiscard]] Handling handling_of(const Autopilot& autopilot, double radius_m, double above_m,
                                   double below_m, bool is_afloat, double barrier_s) noexcept;

/// What an autopilot is to do instead of `wanted`, so that the vehicle keeps clear: where the
/// motion that is wanted does, `wanted` to the last bit. Else a station so far off that the
/// autopilot goes for it at the speed that is clear; for craft that must turn first, their bow that
/// way without way on; for AUVs a heading, or that of the circle to starboard. A depth is held
/// within those that are clear.
///
/// What is measured is taken for true: errors of navigation belong into `stray_m`.
[[nodiscard]] Reference keep_clear(const Handling& handling, const StandOff& stand_off,
                                   const Lookout& lookout, const Autopilot& autopilot,
                                   const Measured& measured, const Reference& wanted, double dt_s,
                                   ClearanceState& state) noexcept;

/// The motion of a vehicle as a clearance has it. @param r  of its attitude
[[nodiscard]] OwnMotion own_motion(const Triple<double>& position_m, const Rotation<double>& r,
                                   const Triple<double>& velocity_ned_m_s) noexcept;

}  // namespace slackwater::twin
