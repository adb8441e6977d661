#include "api/door/dds/message/services.h"

#include <cmath>

#include "api/door/dds/message/cdr.h"
#include "api/door/dds/message/map_frame.h"
#include "api/door/dds/message/path_message.h"
#include "api/door/dds/message/profile_message.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "std_srvs.h"
#include "twin/body/attitude.h"

namespace slackwater::dds {
namespace {

/// slackwater_msgs/srv/SetWaypoints_Request.
struct SetWaypointsRequest {
  PathAsked path;
  bool loop = false;

  void deserialize(eprosima::fastcdr::Cdr& cdr) {
    path.deserialize(cdr);
    cdr >> loop;
  }
};

}  // namespace

void read_trigger(Payload request) { (void)decoded<std_srvs::srv::Trigger_Request>(request); }

bool read_set_bool(Payload request) {
  return decoded<std_srvs::srv::SetBool_Request>(request).data();
}

Bytes done_reply(bool success, const std::string& message) {
  std_srvs::srv::SetBool_Response reply;
  reply.success(success);
  reply.message(message);
  return encoded(reply);
}

std::uint32_t read_step(Payload request) {
  return decoded<slackwater_msgs::srv::Step_Request>(request).steps();
}

Bytes step_reply(bool success) {
  slackwater_msgs::srv::Step_Response reply;
  reply.success(success);
  return encoded(reply);
}

twin::Newcomer read_spawn(Payload request) {
  const auto asked = decoded<slackwater_msgs::srv::Spawn_Request>(request);
  expect_map("the pose", asked.pose().header().frame_id());
  const geometry_msgs::msg::Quaternion& q = asked.pose().pose().orientation();
  const double length = std::sqrt(q.x() * q.x() + q.y() * q.y() + q.z() * q.z() + q.w() * q.w());
  constexpr double rounding = 0.01;  // of what people type
  if (!(std::abs(length - 1) <= rounding))
    throw Error(ErrorKind::invalid_input,
                formatted("the pose has an orientation of length {:g}, expected a quaternion of "
                          "length 1: {{w: 1}} looks east",
                          length));
  const twin::Attitude<double> attitude =
      enu_flu_ned_frd({q.w() / length, q.x() / length, q.y() / length, q.z() / length});
  return {asked.model(), asked.name(), enu_ned(triple_of(asked.pose().pose().position())),
          twin::euler_angles(attitude).yaw_rad};
}

WaypointsAsked read_set_waypoints(Payload request) {
  const auto asked = decoded<SetWaypointsRequest>(request);
  return {asked.path.places_m, asked.loop};
}

ProfileAsked read_query_profile(Payload request) {
  const auto asked = decoded<slackwater_msgs::srv::QueryProfile_Request>(request);
  if (asked.time().nanosec() >= 1'000'000'000)
    throw Error(ErrorKind::invalid_input,
                formatted("time: found {} ns within a second, expected less than 1e9; carry them "
                          "into its seconds",
                          asked.time().nanosec()));
  return {asked.latitude(), asked.longitude(), stamp_of(asked.time())};
}

Bytes profile_reply(const SiteWater& water, UtcTime time, const Stamp& stamp) {
  slackwater_msgs::srv::QueryProfile_Response reply;
  reply.success(true);
  reply.profile(profile_message(water, time, stamp));
  return encoded(reply);
}

Bytes profile_refusal(const std::string& message) {
  slackwater_msgs::srv::QueryProfile_Response reply;
  reply.message(message);
  return encoded(reply);
}

}  // namespace slackwater::dds
