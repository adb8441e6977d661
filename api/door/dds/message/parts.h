#pragma once
#include "api/door/dds/message/bytes.h"
#include "api/door/dds/message/frames.h"
#include "geometry_msgs.h"
#include "twin/body/spatial.h"

// Parts that several messages have. Only sources of this folder include this: it shows the types
// that fastddsgen made.

namespace slackwater::dds {

inline builtin_interfaces::msg::Time time_message(const Stamp& stamp) {
  builtin_interfaces::msg::Time time;
  time.sec(stamp.seconds);
  time.nanosec(stamp.nanoseconds);
  return time;
}
inline Stamp stamp_of(const builtin_interfaces::msg::Time& time) {
  return {time.sec(), time.nanosec()};
}

inline std_msgs::msg::Header header_message(const Stamp& stamp, const std::string& frame_id) {
  std_msgs::msg::Header header;
  header.stamp(time_message(stamp));
  header.frame_id(frame_id);
  return header;
}

/// Point or Vector3.
template <typename Message>
Message xyz_message(const twin::Triple<double>& v) {
  Message message;
  message.x(v.x);
  message.y(v.y);
  message.z(v.z);
  return message;
}
template <typename Message>
twin::Triple<double> triple_of(const Message& message) {
  return {message.x(), message.y(), message.z()};
}

inline geometry_msgs::msg::Quaternion quaternion_message(const twin::Attitude<double>& ned_frd) {
  const twin::Attitude<double> q = enu_flu_ned_frd(ned_frd);
  geometry_msgs::msg::Quaternion message;
  message.x(q.x);
  message.y(q.y);
  message.z(q.z);
  message.w(q.w);
  return message;
}

/// @param position_m  NED; @param attitude  of a body in NED
inline geometry_msgs::msg::Pose pose_message(const twin::Triple<double>& position_m,
                                             const twin::Attitude<double>& attitude) {
  geometry_msgs::msg::Pose pose;
  pose.position(xyz_message<geometry_msgs::msg::Point>(enu_ned(position_m)));
  pose.orientation(quaternion_message(attitude));
  return pose;
}

/// @param nu  body axes, forward, right, down
inline geometry_msgs::msg::Twist twist_message(const twin::Spatial<double>& nu) {
  geometry_msgs::msg::Twist twist;
  twist.linear(xyz_message<geometry_msgs::msg::Vector3>(flu_frd(nu.linear)));
  twist.angular(xyz_message<geometry_msgs::msg::Vector3>(flu_frd(nu.angular)));
  return twist;
}

}  // namespace slackwater::dds
