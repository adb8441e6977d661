#pragma once
#include <string>
#include <vector>

#include "api/door/dds/message/bytes.h"
#include "twin/body/spatial.h"

namespace slackwater::dds {

// What clients ask of a vehicle, read from messages. Numbers are handed on as they are: whether a
// vehicle can do that is asked behind the door, for all doors alike (twin/helm).

/// geometry_msgs/msg/Twist: surge, sway, heave and yaw rate through the water. Roll and pitch rates
/// count for nothing.
/// @return body axes, forward, right, down
/// @throws Error(invalid_input) for bytes that are no such message, like all of these
[[nodiscard]] twin::Spatial<double> velocity_asked(Payload message);
/// The same of a geometry_msgs/msg/TwistStamped; its stamp counts for nothing.
/// @throws Error(invalid_input) for one in a frame of the world (REP-105) too: earth, map, odom
[[nodiscard]] twin::Spatial<double> stamped_velocity_asked(Payload message);
/// std_msgs/msg/Float64MultiArray: -1 to 1 for each thruster, in the file's order.
[[nodiscard]] std::vector<double> thrusters_asked(Payload message);
/// slackwater_msgs/msg/Actuators.
struct ActuatorsAsked {
  std::vector<std::string> name;
  std::vector<double> value;  ///< one for each name, or it means nothing: for the reader to say
  bool is_physical = false;   ///< in the unit of each; else shares, -1 to 1
};
[[nodiscard]] ActuatorsAsked actuators_asked(Payload message);
/// nav_msgs/msg/Path in `map`. @return NED, m
/// @throws Error(invalid_input) for a path in another frame too
[[nodiscard]] std::vector<twin::Triple<double>> path_asked(Payload message);

// The same as messages, of what was asked in another way; of a path see `active_waypoints`.

[[nodiscard]] Bytes velocity_order(const twin::Spatial<double>& nu);
[[nodiscard]] Bytes thrusters_order(const std::vector<double>& shares);
[[nodiscard]] Bytes actuators_order(const ActuatorsAsked& asked);

/// Where a vehicle told that it was: geometry_msgs/msg/PoseStamped.
struct PlaceTold {
  Stamp stamp;
  twin::Triple<double> position_m;  ///< NED
};
[[nodiscard]] PlaceTold place_in_pose(Payload message);
/// nav_msgs/msg/Odometry.
[[nodiscard]] PlaceTold place_in_odometry(Payload message);

}  // namespace slackwater::dds
