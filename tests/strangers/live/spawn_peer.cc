// spawn_peer DOMAIN [fill]: lets vehicles join a run of `slackwater live` with the scenario
// data/scenarios/live_square.yaml and drives one of them, as two ROS 2 nodes on rmw_fastrtps would.
// Prints what it saw; exit 0: all as the page "Driving a vehicle from ROS 2" says. fill: as many
// join as there is room for, while another client asks without a pause.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <thread>

#include "rmw_dds_commonPubSubTypes.h"
#include "sensor_msgsPubSubTypes.h"
#include "std_msgsPubSubTypes.h"
#include "tests/strangers/live/peer_checks.h"

namespace {

using namespace peer;

/// Looking north.
slackwater_msgs::srv::Spawn_Request asked(const std::string& model, const std::string& name,
                                          const std::array<double, 3>& at_m) {
  slackwater_msgs::srv::Spawn_Request request;
  request.model(model);
  request.name(name);
  request.pose().header().frame_id("map");
  request.pose().pose().position().x(at_m[0]);
  request.pose().pose().position().y(at_m[1]);
  request.pose().pose().position().z(at_m[2]);
  request.pose().pose().orientation().z(std::sqrt(0.5));
  request.pose().pose().orientation().w(std::sqrt(0.5));
  return request;
}

/// Who has the run lets vehicles join it while others are at their helms.
void ask_for_run(Node& node) {
  SetBool authority(node, "/slackwater/authority");
  std_srvs::srv::SetBool_Request request;
  request.data(true);
  const auto got = authority.call(request, 30);
  expect(got && got->success(), "the run is asked for: " + (got ? got->message() : "no answer"));
}

double apart_m(const nav_msgs::msg::Odometry& odometry, double x, double y) {
  const auto& at = odometry.pose().pose().position();
  return std::hypot(at.x() - x, at.y() - y);
}

/// Endpoints of the run's node in the newest word of `ros_discovery_info`.
std::size_t endpoints_told(fdds::DataReader* graph) {
  std::size_t most = 0;
  while (const auto info = next<rmw_dds_common::msg::ParticipantEntitiesInfo, void>(graph, 0.5))
    for (const auto& node : info->node_entities_info_seq())
      if (node.node_name() == "slackwater")
        most = node.reader_gid_seq().size() + node.writer_gid_seq().size();
  return most;
}

void see_refusals(Spawn& spawn) {
  const auto refused = [&](const slackwater_msgs::srv::Spawn_Request& request,
                           const std::string& what, const std::string& word) {
    const auto answer = spawn.call(request);
    expect(answer && !answer->success() && answer->message().find(word) != std::string::npos,
           what + ": " + (answer ? answer->message() : "no answer"));
  };
  const std::array<double, 3> here{10, -60, -6};
  for (const char* model : {"no_such_boat", "", "../vehicles/x500", "/etc/passwd", "x500.yaml"})
    refused(asked(model, "other", here), std::string("model '") + model + "'", "catalogue");
  for (const char* name : {"", "7_up", "a b", "a/b", "a__b", "a_"})
    refused(asked("x500", name, here), std::string("name '") + name + "'", "token of ROS");
  for (const char* name : {"rov", "ROV", "late", "slackwater", "clock", "site"})
    refused(asked("x500", name, here), std::string("name '") + name + "'", "taken");
  const double nan = std::nan("");
  refused(asked("bluerov2_heavy", "other", {nan, 0, -6}), "a place that is no number", "nan");
  refused(asked("bluerov2_heavy", "other", {10, -60, -31}), "below the bed", "below_bed");
  refused(asked("bluerov2_heavy", "other", {10, -60, 5}), "an ROV in the air", "above the sea");
  refused(asked("bluerov2_heavy", "other", {0, 0, -6}), "in the monopile", "is land");
  refused(asked("bluerov2_heavy", "other", {4e5, 0, -6}), "out of the area", "outside_area");
  refused(asked("wamv16", "other", {10, -60, 30}), "a boat in the air", "floats");
  refused(asked("x500", "other", {10, -60, -6}), "a multirotor in the sea", "below the sea");
  auto elsewhere = asked("bluerov2_heavy", "other", here);
  elsewhere.pose().header().frame_id("odom");
  refused(elsewhere, "another frame", "frame");
  auto no_way = asked("bluerov2_heavy", "other", here);
  no_way.pose().pose().orientation().w(0);
  no_way.pose().pose().orientation().z(0);
  refused(no_way, "an orientation that is none", "quaternion");
}

/// As many as there is room for, while another client asks as fast as it can.
int fill(int domain) {
  Node node(domain);
  std::atomic<bool> is_over = false;
  std::atomic<int> answers = 0;
  std::thread busy([&] {
    Node other(domain);
    SetBool authority(other, "/rov/authority");
    std_srvs::srv::SetBool_Request request;
    for (; !is_over; request.data(!request.data()))
      if (authority.call(request)) ++answers;
  });
  // One that is told by topic, from threads for which the run may have to wait.
  std::thread busy_too([&] {
    Node other(domain);
    auto* writer = other.writer<slackwater_msgs::msg::HostRequestPubSubType>("rt/rov/host/request");
    slackwater_msgs::msg::HostRequest request;
    for (request.version(99); !is_over; std::this_thread::sleep_for(std::chrono::microseconds(50)))
      writer->write(&request);
  });
  Spawn spawn(node, "/slackwater/spawn");
  ask_for_run(node);  // the busy one is at a helm now and then
  int joined = 0;
  double longest_s = 0;
  std::string refusal;
  while (joined <= 64) {
    const auto asked_at = Clock::now();
    const auto answer = spawn.call(asked("bluerov2_heavy", "v" + std::to_string(joined),
                                         {10.0 + 5 * (joined % 8), -100.0 + 5 * (joined / 8), -6}),
                                   30);
    longest_s = std::max(longest_s, std::chrono::duration<double>(Clock::now() - asked_at).count());
    if (!answer || !answer->success()) {
      refusal = answer ? answer->message() : "no answer";
      break;
    }
    ++joined;
  }
  is_over = true;
  busy.join();
  busy_too.join();
  expect(joined == 64, "64 vehicles join");
  expect(refusal.find("the most that this run can hold") != std::string::npos,
         "and no more: " + refusal);
  expect(answers > joined, "while another client is answered all the time");
  auto* last = node.reader<nav_msgs::msg::OdometryPubSubType>("rt/v63/odometry");
  expect(next<nav_msgs::msg::Odometry, void>(last, 10).has_value(), "the last one is there");
  std::printf("%d answers to another client meanwhile; the slowest to join took %.0f ms\n",
              answers.load(), 1000 * longest_s);
  return failures == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const int domain = std::atoi(argv[1]);
  if (argc > 2) return fill(domain);
  Node node(domain), other(domain);
  auto* graph = node.reader<rmw_dds_common::msg::ParticipantEntitiesInfoPubSubType>(
      "ros_discovery_info", true);

  // --- it joins ---
  ask_for_run(node);
  Spawn spawn(node, "/slackwater/spawn");
  const std::size_t before = endpoints_told(graph);
  const auto joined = spawn.call(asked("bluerov2_heavy", "late", {10, -40, -6}), 30);
  expect(joined && joined->success(),
         "a vehicle joins: " + (joined ? joined->message() : "no answer"));
  if (!joined || !joined->success()) return 1;
  auto* odometry = node.reader<nav_msgs::msg::OdometryPubSubType>("rt/late/odometry");
  auto* battery =
      node.reader<sensor_msgs::msg::BatteryStatePubSubType>("rt/late/battery_state", true);
  auto* mission = node.reader<std_msgs::msg::StringPubSubType>("rt/late/mission_state", true);
  const auto at = next<nav_msgs::msg::Odometry, void>(odometry);
  expect(at && apart_m(*at, 10, -40) < 1 && std::abs(at->pose().pose().position().z() + 6) < 1,
         "where it was asked for");
  expect(at && at->header().frame_id() == "map" && at->child_frame_id() == "late/base_link",
         "in its frames");
  const auto charge = next<sensor_msgs::msg::BatteryState, void>(battery);
  expect(charge && charge->percentage() > 0.9 && charge->current() < 0,
         "with a battery that it draws from");
  const auto state = next<std_msgs::msg::String, void>(mission);
  expect(state && state->data().find("\"authority\":\"\"") != std::string::npos,
         "which nobody holds: " + (state ? state->data() : ""));
  const std::size_t after = endpoints_told(graph);
  expect(after > before + 20, "the node's list has its topics: " + std::to_string(before) + ", " +
                                  std::to_string(after));

  // --- who drives it ---
  SetBool authority(node, "/late/authority"), others(other, "/late/authority");
  SetWaypoints set_waypoints(node, "/late/set_waypoints");
  SetWaypoints by_other(other, "/late/set_waypoints");
  std_srvs::srv::SetBool_Request ask, give;
  ask.data(true);
  const auto got = others.call(ask);
  expect(got && got->success(), "another client asks for it and has it");
  slackwater_msgs::srv::SetWaypoints_Request waypoints;
  waypoints.path(path_of({{14, -40, -8}}));
  const auto unauthorised = set_waypoints.call(waypoints);
  expect(unauthorised && !unauthorised->success(),
         "who let it in has no word in that: " + (unauthorised ? unauthorised->message() : ""));
  const auto set = by_other.call(waypoints);
  expect(set && set->success(), "its holder drives it");
  double least_m = 1e9;
  for (int i = 0; i < 4000 && least_m > 0.5; ++i)
    if (const auto now = next<nav_msgs::msg::Odometry, void>(odometry, 1))
      least_m = std::min(least_m, apart_m(*now, 14, -40));
  expect(least_m <= 0.5, "and sees it come to its waypoint");
  const auto given = others.call(give);
  expect(given && given->success(), "which gives it back");

  SendGoal send_goal(node, "/late/navigate/_action/send_goal");
  slackwater_msgs::action::Navigate_SendGoal_Request goal;
  goal.goal_id().uuid()[0] = 1;
  goal.goal().path(path_of({{10, -40, -6}}));
  const auto sent = send_goal.call(goal);
  expect(sent && sent->accepted(), "a goal of the navigation action is accepted");

  // --- a second one while the run is paused ---
  Trigger pause(node, "/slackwater/pause"), resume(node, "/slackwater/resume");
  const auto paused = pause.call({});
  expect(paused && paused->success(), "paused");
  Trigger resume_too(other, "/slackwater/resume");
  const auto not_by_other = resume_too.call({});
  expect(not_by_other && !not_by_other->success() &&
             not_by_other->message().find("the run is held by dds ") == 0,
         "who does not have the run does not let it go on: " +
             (not_by_other ? not_by_other->message() : ""));
  const auto waiting = spawn.call(asked("wamv16", "late_usv", {40, -40, 0}), 1.5);
  expect(!waiting, "a paused run lets nobody in");
  const auto resumed = resume.call({});
  expect(resumed && resumed->success(), "resumed");
  auto* second = node.reader<nav_msgs::msg::OdometryPubSubType>("rt/late_usv/odometry");
  expect(next<nav_msgs::msg::Odometry, void>(second, 10).has_value(), "it comes when it goes on");

  see_refusals(spawn);
  std::printf("%d failed\n", failures);
  return failures == 0 ? 0 : 1;
}
