#pragma once
#include "api/ask/vehicle/vehicle_check.h"

namespace slackwater::api {

/// See `check_vehicle`. @param file  of the vehicle, which swims or floats
[[nodiscard]] std::vector<FlownManoeuvre> manoeuvres_of_check(const twin::Vehicle& vehicle,
                                                              const twin::Autopilot& autopilot,
                                                              const std::filesystem::path& file);

}  // namespace slackwater::api
