#include "api/door/live/command_topics.h"

#include <array>
#include <exception>

#include "api/door/dds/message/orders.h"
#include "api/door/dds/message/vehicle_messages.h"
#include "api/door/live/reroute.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/vehicle/actuator_channels.h"

namespace slackwater::live {
namespace {

constexpr const char* stamped_type = "geometry_msgs/msg/TwistStamped";

twin::CommandWhat velocity_of(const twin::Spatial<double>& nu) {
  if (nu.angular.x != 0 || nu.angular.y != 0)
    throw Error(ErrorKind::invalid_input,
                formatted("angular: found {:g} rad/s of roll and {:g} of pitch, expected 0: a "
                          "vehicle keeps them by itself; ask for surge, sway, heave and yaw",
                          nu.angular.x, nu.angular.y));
  return twin::SetVelocity{{nu.linear.x, nu.linear.y, nu.linear.z, nu.angular.z}};
}
twin::CommandWhat velocity(dds::Payload message, const twin::Vehicle& /*any*/) {
  return velocity_of(dds::velocity_asked(message));
}
twin::CommandWhat stamped_velocity(dds::Payload message, const twin::Vehicle& /*any*/) {
  return velocity_of(dds::stamped_velocity_asked(message));
}
twin::CommandWhat thrusters(dds::Payload message, const twin::Vehicle& /*any*/) {
  return twin::SetThrusters{dds::thrusters_asked(message)};
}
twin::CommandWhat actuators(dds::Payload message, const twin::Vehicle& vehicle) {
  const dds::ActuatorsAsked asked = dds::actuators_asked(message);
  return twin::SetActuators{twin::values_by_name(vehicle, asked.name, asked.value),
                            asked.is_physical};
}
twin::CommandWhat waypoints(dds::Payload message, const twin::Vehicle& /*any*/) {
  return reroute_to(dds::path_asked(message));
}

dds::Bytes actuators_order(const twin::SetActuators& set, const twin::Vehicle& vehicle) {
  dds::ActuatorsAsked asked;
  asked.is_physical = set.is_physical;
  for (std::size_t i = 0; i < twin::most_channels; ++i) {
    const auto channel = twin::channel_of(vehicle, i);
    if (!channel || !set.given.has(i)) continue;
    asked.name.emplace_back(channel->name);
    asked.value.push_back(set.given.value[i]);
  }
  return dds::actuators_order(asked);
}

// The stamped one first, so that who writes it on the other one's topic is told of it.
constexpr std::array<CommandTopic, 5> topics{
    CommandTopic{"cmd_vel_stamped", stamped_type, stamped_velocity},
    CommandTopic{"cmd_vel", "geometry_msgs/msg/Twist", velocity},
    CommandTopic{"thrusters", "std_msgs/msg/Float64MultiArray", thrusters},
    CommandTopic{"actuators", "slackwater_msgs/msg/Actuators", actuators},
    CommandTopic{"waypoints", "nav_msgs/msg/Path", waypoints}};

}  // namespace

std::span<const CommandTopic> command_topics() noexcept { return topics; }

const CommandTopic* command_topic_of(std::string_view name, std::string_view type) noexcept {
  for (const CommandTopic& topic : topics) {
    const bool is_its_name =
        name == topic.name || (name == "cmd_vel" && topic.read == stamped_velocity);
    if (is_its_name && type == topic.type) return &topic;
  }
  return nullptr;
}

bool hand_in(CommandDoor& command_door, const std::string& client, std::size_t vehicle,
             const CommandTopic& topic, dds::Payload message, double held_back_s) {
  try {
    const auto model = command_door.model(vehicle);
    twin::CommandWhat what = topic.read(message, *model);
    dds::Bytes heard = topic.read == stamped_velocity ? order_of(what, *model)
                                                      : dds::Bytes(message.begin(), message.end());
    return !command_door.submit(client, vehicle, std::move(what), heard, held_back_s).refusal;
  } catch (const std::exception& e) {
    command_door.refuse(client, vehicle, e.what());
    return false;
  }
}

dds::Bytes order_of(const twin::CommandWhat& what, const twin::Vehicle& vehicle) {
  if (const auto* set = std::get_if<twin::SetVelocity>(&what)) {
    const twin::HelmVelocity& v = set->velocity;
    constexpr double none_to_port = -0.0;  // 0 once it is turned to port
    return dds::velocity_order(
        {{v.surge_m_s, v.sway_m_s, v.heave_m_s}, {0, none_to_port, v.yaw_rate_rad_s}});
  }
  if (const auto* set = std::get_if<twin::SetThrusters>(&what))
    return dds::thrusters_order(set->share);
  if (const auto* set = std::get_if<twin::SetActuators>(&what))
    return actuators_order(*set, vehicle);
  if (const auto* reroute = std::get_if<twin::Reroute>(&what))
    return dds::active_waypoints(reroute->waypoints, {});
  return {};
}

}  // namespace slackwater::live
