#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace slackwater::bag {

/// The hash by which ROS 2 knows a type since Iron: "RIHS01_" and the SHA-256 of the type's
/// description as JSON. Names and types of fields count; comments, constants and defaults do not.
///
/// @param type        "nav_msgs/msg/Odometry", or a part of an action
/// @param definition  "ros2msg": the fields of the type, then of each type that it holds after a
///                    line of 80 '=' and "MSG: package/Name"; parts of actions by their full names,
///                    "package/action/Name_Goal"
/// @return nothing where the definition cannot be followed: a type that it does not define, one of
///         `wstring`, on which readers differ, or a part of a service or action that is not named
///         in full
/// Source: ROS REP-2016; rosidl, rosidl_generator_type_description.
[[nodiscard]] std::optional<std::string> type_hash(std::string_view type,
                                                   std::string_view definition);

/// The same of a service: of its request, its response and the event that tells of a call.
/// @param type  "std_srvs/srv/Trigger", or of an action "package/action/Name_SendGoal"
/// Source: as above; the layout of the event, rosidl_parser (`Service`).
[[nodiscard]] std::optional<std::string> service_type_hash(std::string_view type,
                                                           std::string_view request_definition,
                                                           std::string_view response_definition);

}  // namespace slackwater::bag
