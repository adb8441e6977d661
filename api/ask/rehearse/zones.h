#pragma once
#include <string>

#include "api/ask/rehearse/mission_file.h"

namespace slackwater::api {

/// Why a mission may not be flown from a start: an exclusion zone of the site that is in force
/// then and that a vehicle's way leads through, or that it starts in. Empty: it may.
///
///     "surveyor: its way leads through zone terns (breeding terns), in force then"
[[nodiscard]] std::string zone_in_the_way(const LoadedMission& mission, UtcTime start);

}  // namespace slackwater::api
