#include "api/dds/message/orders.h"

#include "api/dds/message/cdr.h"
#include "api/dds/message/path_message.h"

namespace slackwater::dds {
namespace {

void expect_map(const std::string& frame_id) {
  if (frame_id.empty() || frame_id == "map") return;
  throw Error(ErrorKind::invalid_input, "the path is in the frame '" + frame_id.substr(0, 80) +
                                            "'; give it in `map`: east, north, up of the origin");
}

}  // namespace

std::vector<twin::Triple<double>> places_of(const nav_msgs::msg::Path& path) {
  expect_map(path.header().frame_id());
  std::vector<twin::Triple<double>> places;
  for (const geometry_msgs::msg::PoseStamped& pose : path.poses()) {
    expect_map(pose.header().frame_id());
    places.push_back(enu_ned(triple_of(pose.pose().position())));
  }
  return places;
}

twin::Spatial<double> velocity_asked(Payload message) {
  const auto twist = decoded<geometry_msgs::msg::Twist>(message);
  twin::Spatial<double> nu;
  nu.linear = flu_frd(triple_of(twist.linear()));
  nu.angular = flu_frd(triple_of(twist.angular()));
  return nu;
}

std::vector<double> thrusters_asked(Payload message) {
  return decoded<std_msgs::msg::Float64MultiArray>(message).data();
}

std::vector<twin::Triple<double>> path_asked(Payload message) {
  return places_of(decoded<nav_msgs::msg::Path>(message));
}

}  // namespace slackwater::dds
