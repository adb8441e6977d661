#include "api/door/dds/message/orders.h"

#include "api/door/dds/message/cdr.h"
#include "api/door/dds/message/map_frame.h"
#include "api/door/dds/message/path_message.h"
#include "nav_msgs.h"
#include "slackwater_msgs.h"

namespace slackwater::dds {
namespace {

using eprosima::fastcdr::Cdr;

/// std_msgs/msg/Float64MultiArray, of which the numbers count and not how they are laid out.
struct NumbersAsked {
  std::vector<double> numbers;

  void deserialize(Cdr& cdr) {
    for_each_element<std_msgs::msg::MultiArrayDimension>(cdr, [](const auto&) {});
    std::uint32_t data_offset = 0;
    cdr >> data_offset;
    for_each_element<double>(cdr, [&](double number) { numbers.push_back(number); });
  }
};

/// slackwater_msgs/msg/Actuators, its lists read one by one.
struct NamedNumbersAsked {
  ActuatorsAsked asked;

  void deserialize(Cdr& cdr) {
    for_each_element<std::string>(
        cdr, [&](std::string& name) { asked.name.push_back(std::move(name)); });
    for_each_element<double>(cdr, [&](double value) { asked.value.push_back(value); });
    cdr >> asked.is_physical;
  }
};

/// In body axes, forward, right, down.
twin::Spatial<double> velocity_of(const geometry_msgs::msg::Twist& twist) {
  twin::Spatial<double> nu;
  nu.linear = flu_frd(triple_of(twist.linear()));
  nu.angular = flu_frd(triple_of(twist.angular()));
  return nu;
}

}  // namespace

void PathAsked::deserialize(Cdr& cdr) {
  std_msgs::msg::Header header;
  cdr >> header;
  expect_map("the path", header.frame_id());
  for_each_element<geometry_msgs::msg::PoseStamped>(cdr, [&](const auto& pose) {
    expect_map("the path", pose.header().frame_id());
    places_m.push_back(enu_ned(triple_of(pose.pose().position())));
  });
}

twin::Spatial<double> velocity_asked(Payload message) {
  return velocity_of(decoded<geometry_msgs::msg::Twist>(message));
}

twin::Spatial<double> stamped_velocity_asked(Payload message) {
  const auto asked = decoded<geometry_msgs::msg::TwistStamped>(message);
  const std::string& frame = asked.header().frame_id();
  if (frame == "earth" || frame == map_frame || frame == "odom") {
    throw Error(ErrorKind::invalid_input,
                "the velocity is in the frame " + frame +
                    ", expected the vehicle's own (base_link); turn it into that");
  }
  return velocity_of(asked.twist());
}

std::vector<double> thrusters_asked(Payload message) {
  return decoded<NumbersAsked>(message).numbers;
}

ActuatorsAsked actuators_asked(Payload message) {
  return decoded<NamedNumbersAsked>(message).asked;
}

std::vector<twin::Triple<double>> path_asked(Payload message) {
  return decoded<PathAsked>(message).places_m;
}

Bytes velocity_order(const twin::Spatial<double>& nu) { return encoded(twist_message(nu)); }

Bytes thrusters_order(const std::vector<double>& shares) {
  std_msgs::msg::Float64MultiArray message;
  message.data(shares);
  return encoded(message);
}

Bytes actuators_order(const ActuatorsAsked& asked) {
  slackwater_msgs::msg::Actuators message;
  message.name(asked.name);
  message.value(asked.value);
  message.is_physical(asked.is_physical);
  return encoded(message);
}

PlaceTold place_in_pose(Payload message) {
  const auto told = decoded<geometry_msgs::msg::PoseStamped>(message);
  return {stamp_of(told.header().stamp()), enu_ned(triple_of(told.pose().position()))};
}

PlaceTold place_in_odometry(Payload message) {
  const auto told = decoded<nav_msgs::msg::Odometry>(message);
  return {stamp_of(told.header().stamp()), enu_ned(triple_of(told.pose().pose().position()))};
}

}  // namespace slackwater::dds
