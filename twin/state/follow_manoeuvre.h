#pragma once
#include "twin/state/mission.h"

namespace slackwater::twin {

/// Begins the manoeuvre that is the task under way, at the depth that is kept and as the bow lies.
void begin_manoeuvre(const ManoeuvrePlan& plan, const Measured& measured, double t_s,
                     MissionState& state);

/// A step of it: what is due is ordered. Where somebody else had the vehicle meanwhile it begins
/// anew, with its approach and at the depth where it is: what was interrupted is no manoeuvre.
/// @return false: it is over
[[nodiscard]] bool go_on(const ManoeuvrePlan& plan, const Measured& measured, double t_s,
                         double dt_s, MissionState& state);

/// What the autopilot is to keep meanwhile. While the helm is put over that is the depth alone; of
/// the rest what is, so that nothing acts for it.
[[nodiscard]] Reference reference_of(const ManoeuvrePlan& plan, const Measured& measured,
                                     const MissionState& state);

/// Takes the mean of what drives the vehicle, as long as that is what is held later on: in the last
/// fifth of an approach.
/// @param push_n       of the thrusters ahead
/// @param advance_m_s  ahead through the water
/// @param voltage_v    of the bus
void note_propulsion(const ManoeuvrePlan& plan, double push_n, double advance_m_s, double voltage_v,
                     double dt_s, MissionState& state) noexcept;

}  // namespace slackwater::twin
