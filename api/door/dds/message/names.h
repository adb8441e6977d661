#pragma once
#include <string>
#include <string_view>

namespace slackwater::dds {

// How ROS 2 names things on DDS (ros2/design articles/140).

/// "nav_msgs/msg/Odometry" -> "nav_msgs::msg::dds_::Odometry_".
[[nodiscard]] std::string dds_type(std::string_view ros_type);
/// "/rov/odometry" -> "rt/rov/odometry".
[[nodiscard]] std::string dds_topic(std::string_view ros_topic);
/// "/slackwater/pause" -> "rq/slackwater/pauseRequest", "rr/slackwater/pauseReply".
[[nodiscard]] std::string request_topic(std::string_view ros_service);
[[nodiscard]] std::string reply_topic(std::string_view ros_service);
/// "std_srvs/srv/Trigger" -> "std_srvs::srv::dds_::Trigger_Request_".
[[nodiscard]] std::string request_type(std::string_view ros_type);
[[nodiscard]] std::string reply_type(std::string_view ros_type);

/// For people, and the other way round: "rt/rov/odometry" -> "/rov/odometry",
/// "rq/slackwater/pauseRequest" -> "/slackwater/pause (requests)". Other names stay as they are.
[[nodiscard]] std::string ros_topic_of(const std::string& topic);
/// "nav_msgs::msg::dds_::Odometry_" -> "nav_msgs/msg/Odometry". Other names stay as they are.
[[nodiscard]] std::string ros_type_of(const std::string& type);

/// A name as a token of ROS: letters, digits and single underscores, no digit first, no underscore
/// last. What is none becomes an underscore; "7 north" -> "n7_north", "" -> "n".
[[nodiscard]] std::string ros_token(std::string_view name);

}  // namespace slackwater::dds
