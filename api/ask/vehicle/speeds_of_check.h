#pragma once
#include "api/ask/vehicle/vehicle_check.h"

namespace slackwater::api {

/// A vehicle at rest where it hovers, at half its cruise speed (an AUV no slower than its fins
/// steer it), at that, between it and its top speed, and at that.
[[nodiscard]] std::vector<AtSpeed> speeds_of_check(const twin::Vehicle& vehicle,
                                                   const twin::Autopilot& autopilot,
                                                   double top_speed_m_s);

}  // namespace slackwater::api
