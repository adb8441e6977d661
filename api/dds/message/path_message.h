#pragma once
#include "api/dds/message/parts.h"
#include "nav_msgs.h"

// Only sources of this folder include this: it shows the types that fastddsgen made.

namespace slackwater::dds {

/// NED, m. @throws Error(invalid_input) for a path in another frame than `map`
[[nodiscard]] std::vector<twin::Triple<double>> places_of(const nav_msgs::msg::Path& path);

}  // namespace slackwater::dds
