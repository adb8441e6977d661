#pragma once
#include <optional>
#include <string>

#include "api/door/dds/message/hosted.h"

namespace slackwater::live {

/// Why what hosted physics made of a step is no motion of that vehicle; nothing: it may be one.
/// Bounds of what can move at all, wide enough for any model of it: numbers that are finite, an
/// attitude of length one, no more than 100 m/s and 20 rad/s, no more than 200 m/s2, and a place
/// that its velocities lead to within a tenth of a metre and a tenth of the way; of a wrench no
/// more than 100 times the vehicle's weight.
[[nodiscard]] std::optional<std::string> unphysical(const dds::PhysicsMade& made,
                                                    const twin::HostedStep& step);

/// The vehicle at the end of the step. @param made  that `unphysical` has nothing against
[[nodiscard]] twin::VehicleState<double> state_after(const dds::PhysicsMade& made,
                                                     const twin::HostedStep& step);

}  // namespace slackwater::live
