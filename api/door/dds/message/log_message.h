#pragma once
#include <string>

#include "api/door/dds/message/bytes.h"

namespace slackwater::dds {

/// rcl_interfaces/msg/Log: a warning, as nodes of ROS 2 write it on `/rosout`.
/// @param node  that says it
[[nodiscard]] Bytes warning_message(const Stamp& stamp, const std::string& node,
                                    const std::string& text);

}  // namespace slackwater::dds
