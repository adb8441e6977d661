#pragma once
#include <string>
#include <string_view>

namespace slackwater::dds {

/// The fields of a type as ROS writes them ("ros2msg"), then those of the types that it holds, each
/// behind a line of 80 = and "MSG: package/Name". Made from api/door/dds/idl, which says what the
/// types are.
/// @param ros_type  "nav_msgs/msg/Odometry"
/// @throws ContractViolation for a type that is not there
[[nodiscard]] std::string definition_of(std::string_view ros_type);

/// "RIHS01_…", by which ROS 2 knows the type since Iron (data/bag/type_hash.h): of a message, or
/// of a service as a whole, "std_srvs/srv/Trigger". Empty of a type that is not there.
[[nodiscard]] std::string type_hash_of(std::string_view ros_type);

}  // namespace slackwater::dds
