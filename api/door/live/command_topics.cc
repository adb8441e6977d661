#include "api/door/live/command_topics.h"

#include <array>
#include <exception>

#include "api/door/dds/message/orders.h"
#include "api/door/live/reroute.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::live {
namespace {

twin::CommandWhat velocity(dds::Payload message) {
  const twin::Spatial<double> nu = dds::velocity_asked(message);
  if (nu.angular.x != 0 || nu.angular.y != 0)
    throw Error(ErrorKind::invalid_input,
                formatted("angular: found {:g} rad/s of roll and {:g} of pitch, expected 0: a "
                          "vehicle keeps them by itself; ask for surge, sway, heave and yaw",
                          nu.angular.x, nu.angular.y));
  return twin::SetVelocity{{nu.linear.x, nu.linear.y, nu.linear.z, nu.angular.z}};
}
twin::CommandWhat thrusters(dds::Payload message) {
  return twin::SetThrusters{dds::thrusters_asked(message)};
}
twin::CommandWhat waypoints(dds::Payload message) { return reroute_to(dds::path_asked(message)); }

constexpr std::array<CommandTopic, 3> topics{
    CommandTopic{"cmd_vel", "geometry_msgs/msg/Twist", velocity},
    CommandTopic{"thrusters", "std_msgs/msg/Float64MultiArray", thrusters},
    CommandTopic{"waypoints", "nav_msgs/msg/Path", waypoints}};

}  // namespace

std::span<const CommandTopic> command_topics() noexcept { return topics; }

void hand_in(CommandDoor& command_door, const std::string& client, std::size_t vehicle,
             twin::CommandWhat (*read)(dds::Payload), dds::Payload message, double held_back_s) {
  try {
    (void)command_door.submit(client, vehicle, read(message),
                              dds::Bytes(message.begin(), message.end()), held_back_s);
  } catch (const std::exception& e) {
    command_door.refuse(client, vehicle, e.what());
  }
}

}  // namespace slackwater::live
