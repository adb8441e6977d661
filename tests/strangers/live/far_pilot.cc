// far_pilot DOMAIN VEHICLE METRES: a ROS 2 node at the other end of a bad link, over UDP alone. It
// sends the vehicle that far east of where it is, says "sent" when that is answered and "under way"
// when it has seen it move; then it waits to be killed. Exit 1: not within three minutes each.
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "nav_msgsPubSubTypes.h"
#include "tests/strangers/live/services.h"

namespace {

using namespace peer;
constexpr double patience_s = 180;

void say(const char* what) {
  std::puts(what);
  std::fflush(stdout);
}

/// Waits for a place at least so far from the other.
std::optional<geometry_msgs::msg::Point> place(fdds::DataReader* odometry,
                                               const geometry_msgs::msg::Point& from = {},
                                               double away_m = -1) {
  const auto until = Clock::now() + std::chrono::duration<double>(patience_s);
  nav_msgs::msg::Odometry message;
  fdds::SampleInfo info;
  while (Clock::now() < until) {
    while (odometry->take_next_sample(&message, &info) == ReturnCode_t::RETCODE_OK) {
      const auto& at = message.pose().pose().position();
      if (info.valid_data && std::hypot(at.x() - from.x(), at.y() - from.y()) > away_m) return at;
    }
    odometry->wait_for_unread_message({0, 20'000'000});
  }
  return std::nullopt;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const std::string vehicle = std::string("/") + argv[2];
  Node node(std::atoi(argv[1]), Transports::udp_only);
  auto* odometry = node.reader<nav_msgs::msg::OdometryPubSubType>("rt" + vehicle + "/odometry");
  const auto start = place(odometry);
  if (!start) return 1;
  geometry_msgs::msg::PoseStamped there;
  there.pose().position(*start);
  there.pose().position().x(start->x() + std::atof(argv[3]));
  slackwater_msgs::srv::SetWaypoints_Request request;
  request.path().header().frame_id("map");
  request.path().poses({there});
  const auto reply = SetWaypoints(node, vehicle + "/set_waypoints").call(request, patience_s);
  if (!reply || !reply->success()) {
    say(reply ? reply->message().c_str() : "no answer");
    return 1;
  }
  say("sent");
  if (!place(odometry, *start, 1)) return 1;
  say("under way");
  for (;;) ::pause();
}
