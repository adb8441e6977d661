#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace slackwater::bag {

/// What readers of a topic may rely on (ROS 2's words for it).
struct Quality {
  bool is_reliable = true;
  bool is_transient_local = false;  ///< who comes late gets what was last said
  std::int32_t depth = 10;          ///< keep last

  bool operator==(const Quality&) const = default;
};

/// A topic whose messages are recorded, or sent to people. Messages are bytes: XCDR1, little
/// endian, with their encapsulation header of four, as they are on the wire.
struct Channel {
  std::string topic;       ///< ROS name: "/rov/odometry"
  std::string type;        ///< "nav_msgs/msg/Odometry"
  std::string definition;  ///< "ros2msg": the type's fields, then those of the types it holds
  Quality quality;

  bool operator==(const Channel&) const = default;
};

using Payload = std::span<const std::uint8_t>;

}  // namespace slackwater::bag
