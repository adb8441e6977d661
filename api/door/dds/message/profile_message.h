#pragma once
#include "api/door/dds/message/site_messages.h"
#include "slackwater_msgs.h"

// Only sources of this folder include this: it shows the types that fastddsgen made.

namespace slackwater::dds {

[[nodiscard]] slackwater_msgs::msg::CurrentProfile profile_message(const SiteWater& water,
                                                                   UtcTime time,
                                                                   const Stamp& stamp);

}  // namespace slackwater::dds
