#pragma once
#include "twin/battery/battery.h"

namespace slackwater::twin {

/// s, for which a full battery gives a steady power, until it is empty or cut off. 0: not for a
/// moment; at most 1e8.
/// @param power_w  above 0
[[nodiscard]] double lasts_s(const Battery& battery, double power_w);

}  // namespace slackwater::twin
