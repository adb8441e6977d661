#pragma once
#include "fields/base/config.h"
#include "twin/sensor/adcp.h"

namespace slackwater::twin {

/// `adcp` of a vehicle's sensors, or of a sensor of its own: what differs from the defaults. Angles
/// in degrees. @throws Error(invalid_input)
[[nodiscard]] Adcp read_adcp(const Config& adcp);

}  // namespace slackwater::twin
