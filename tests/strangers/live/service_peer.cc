// service_peer DOMAIN VEHICLE SITE: calls every service of a run of `slackwater live` in which
// VEHICLE is free, and flies a navigation goal, as a ROS 2 node on rmw_fastrtps would. Prints what
// it saw; exit 0: all as the page "Driving a vehicle from ROS 2" says.
#include <cmath>
#include <cstdlib>

#include "geometry_msgsPubSubTypes.h"
#include "std_msgsPubSubTypes.h"
#include "tests/strangers/live/peer_checks.h"

namespace {

using namespace peer;

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const int domain = std::atoi(argv[1]);
  const std::string vehicle = "/" + std::string(argv[2]);
  Node node(domain), other(domain);

  // --- authority ---
  SetBool authority(node, vehicle + "/authority"), others(other, vehicle + "/authority");
  std_srvs::srv::SetBool_Request ask, give;
  ask.data(true);
  const auto got = authority.call(ask, 30);
  expect(got && got->success(), "authority is given to who asks");
  if (!got) return 1;
  const auto refused = others.call(ask);
  expect(refused && !refused->success(),
         "and to nobody else: " + (refused ? refused->message() : ""));
  const auto stolen = others.call(give);
  expect(stolen && !stolen->success(), "nor can another give it back");

  auto* odometry = node.reader<nav_msgs::msg::OdometryPubSubType>("rt" + vehicle + "/odometry");
  const auto at = newest<nav_msgs::msg::Odometry>(odometry);
  expect(at.has_value(), "odometry comes");
  if (!at) return 1;
  const auto& here = at->pose().pose().position();

  // --- waypoints ---
  SetWaypoints set_waypoints(node, vehicle + "/set_waypoints");
  SetWaypoints by_other(other, vehicle + "/set_waypoints");
  slackwater_msgs::srv::SetWaypoints_Request waypoints;
  waypoints.path(path_of({{here.x() + 3, here.y(), here.z()}}));
  const auto set = set_waypoints.call(waypoints);
  expect(set && set->success(), "waypoints are taken from the holder");
  const auto unauthorised = by_other.call(waypoints);
  expect(unauthorised && !unauthorised->success(),
         "and refused to others: " + (unauthorised ? unauthorised->message() : ""));
  waypoints.path(path_of({{here.x(), here.y(), std::nan("")}}));
  const auto no_number = set_waypoints.call(waypoints);
  expect(no_number && !no_number->success(),
         "a place that is no number: " + (no_number ? no_number->message() : ""));
  waypoints.path().header().frame_id("odom");
  const auto frame = set_waypoints.call(waypoints);
  expect(frame && !frame->success(), "another frame: " + (frame ? frame->message() : ""));

  // --- the action ---
  const std::string action = vehicle + "/navigate/_action/";
  SendGoal send_goal(node, action + "send_goal");
  GetResult get_result(node, action + "get_result");
  CancelGoal cancel_goal(node, action + "cancel_goal");
  auto* feedback = node.reader<slackwater_msgs::action::Navigate_FeedbackMessagePubSubType>(
      "rt" + action + "feedback");
  auto* status =
      node.reader<action_msgs::msg::GoalStatusArrayPubSubType>("rt" + action + "status", true);
  slackwater_msgs::action::Navigate_SendGoal_Request goal;
  goal.goal_id().uuid()[0] = 1;
  goal.goal().path(
      path_of({{here.x() + 2, here.y() + 2, here.z()}, {here.x(), here.y(), here.z()}}));
  const auto sent = send_goal.call(goal);
  expect(sent && sent->accepted(), "a goal is accepted");
  const auto fed = next<slackwater_msgs::action::Navigate_FeedbackMessage, void>(feedback);
  expect(fed && fed->goal_id() == goal.goal_id() && fed->feedback().distance_m() > 0,
         "feedback tells how far it is");
  slackwater_msgs::action::Navigate_GetResult_Request result;
  result.goal_id(goal.goal_id());
  const auto done = get_result.call(result, 120);
  expect(done && done->status() == 4 && done->result().success(), "the goal succeeds");
  const auto back = newest<nav_msgs::msg::Odometry>(odometry);
  const double off_m = back ? std::hypot(back->pose().pose().position().x() - here.x(),
                                         back->pose().pose().position().y() - here.y())
                            : 1e9;
  expect(off_m < 2, "at its last place, " + std::to_string(off_m) + " m off");
  goal.goal_id().uuid()[0] = 2;
  goal.goal().path(path_of({{here.x() + 30, here.y(), here.z()}}));
  const auto second = send_goal.call(goal);
  expect(second && second->accepted(), "a second goal is accepted");
  action_msgs::srv::CancelGoal_Request cancel;
  cancel.goal_info().goal_id(goal.goal_id());
  const auto cancelled = cancel_goal.call(cancel);
  expect(cancelled && cancelled->return_code() == 0 && cancelled->goals_canceling().size() == 1,
         "and cancelled");
  result.goal_id(goal.goal_id());
  const auto result_of_second = get_result.call(result);
  expect(result_of_second && result_of_second->status() == 5, "its result says so");
  goal.goal_id().uuid()[0] = 3;
  const auto third = send_goal.call(goal);
  expect(third && third->accepted(), "a third goal is accepted");
  waypoints.path(path_of({{here.x() + 0.5, here.y(), here.z()}}));
  const auto elsewhere = set_waypoints.call(waypoints);
  expect(elsewhere && elsewhere->success(), "and its client sends the vehicle elsewhere");
  result.goal_id(goal.goal_id());
  const auto replaced = get_result.call(result, 60);
  expect(replaced && replaced->status() == 6 && !replaced->result().success() &&
             replaced->result().message().find("another command") != std::string::npos,
         "which aborts the goal: " + (replaced ? replaced->result().message() : ""));

  // --- what is not taken ---
  auto* refusals = node.reader<std_msgs::msg::StringPubSubType>("rt" + vehicle + "/refused");
  auto* cmd_vel = node.writer<geometry_msgs::msg::TwistPubSubType>("rt" + vehicle + "/cmd_vel");
  std::this_thread::sleep_for(std::chrono::seconds(1));
  const auto send = [&](const geometry_msgs::msg::Twist& asked, double seconds_ago) {
    geometry_msgs::msg::Twist twist = asked;
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    const double sent_s = std::chrono::duration<double>(now).count() - seconds_ago;
    const eprosima::fastrtps::Time_t at(static_cast<std::int32_t>(sent_s),
                                        static_cast<std::uint32_t>(1e9 * std::fmod(sent_s, 1)));
    cmd_vel->write_w_timestamp(&twist, fdds::HANDLE_NIL, at);
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  };
  const auto refusal_of = [&](const geometry_msgs::msg::Twist& asked, double seconds_ago) {
    send(asked, 0);
    send(asked, seconds_ago);
    const auto refusal = next<std_msgs::msg::String, void>(refusals, 1);
    return refusal ? refusal->data() : std::string();
  };
  geometry_msgs::msg::Twist slowly;
  slowly.linear().x(0.1);
  const std::string in_time = refusal_of(slowly, 0.5);
  expect(in_time.empty(), "a velocity of half a second ago is taken: " + in_time);
  const std::string stale = refusal_of(slowly, 3);
  expect(stale.find("\"stale\"") != std::string::npos,
         "one that was held back for three is not: " + stale);
  geometry_msgs::msg::Twist rolling = slowly;
  rolling.angular().x(std::nan(""));
  const std::string rolled = refusal_of(rolling, 0);
  expect(rolled.find("of roll") != std::string::npos, "nor a roll that is no number: " + rolled);

  result.goal_id().uuid()[0] = 9;
  const auto unknown = get_result.call(result);
  expect(unknown && unknown->status() == 0, "of a goal that nobody sent there is none");
  std::optional<action_msgs::msg::GoalStatusArray> states;
  for (int i = 0; i < 50 && (!states || states->status_list().size() < 3 ||
                             states->status_list()[2].status() != 6);
       ++i)
    if (auto later = next<action_msgs::msg::GoalStatusArray, void>(status, 0.2)) states = later;
  expect(states && states->status_list().size() == 3 && states->status_list()[0].status() == 4 &&
             states->status_list()[1].status() == 5 && states->status_list()[2].status() == 6,
         "the status topic has all three");

  // --- the current ---
  QueryProfile query(node, "/slackwater/query_profile");
  slackwater_msgs::srv::QueryProfile_Request place;
  auto* latched = node.reader<slackwater_msgs::msg::CurrentProfilePubSubType>(
      "rt/" + std::string(argv[3]) + "/current_profile", true);
  const auto profile = newest<slackwater_msgs::msg::CurrentProfile>(latched);
  expect(profile && profile->depth_m().size() > 1 &&
             profile->east_p10().size() == profile->depth_m().size(),
         "a late joiner has the forecast's profile");
  if (profile) {
    place.latitude(profile->latitude());
    place.longitude(profile->longitude());
    place.time(profile->header().stamp());
    const auto answered = query.call(place);
    expect(answered && answered->success() &&
               answered->profile().east_m_s() == profile->east_m_s() &&
               answered->profile().north_p90() == profile->north_p90(),
           "asked for there and then it is the same");
  }
  place.latitude(91);
  const auto nowhere = query.call(place);
  expect(nowhere && !nowhere->success(), "no place: " + (nowhere ? nowhere->message() : ""));

  // --- the clock ---
  Trigger pause(node, "/slackwater/pause"), resume(node, "/slackwater/resume");
  Step step(node, "/slackwater/step");
  slackwater_msgs::srv::Step_Request steps;
  steps.steps(20);
  const auto running = step.call(steps);
  expect(running && !running->success(), "a run that goes on makes no single steps");
  const auto paused = pause.call({});
  expect(paused && paused->success(), "paused");
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  auto* pose = node.reader<geometry_msgs::msg::PoseStampedPubSubType>("rt" + vehicle + "/pose");
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  const auto stepped = step.call(steps);
  expect(stepped && stepped->success(), "twenty steps");
  int told = 0;
  geometry_msgs::msg::PoseStamped message;
  fdds::SampleInfo info;
  for (int i = 0; i < 20; ++i) {
    while (pose->take_next_sample(&message, &info) == ReturnCode_t::RETCODE_OK) ++told;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  expect(told == 20, "make twenty poses: " + std::to_string(told));
  const auto resumed = resume.call({});
  expect(resumed && resumed->success(), "resumed");

  // --- who has the run ---
  Trigger pause_too(other, "/slackwater/pause");
  SetBool run_authority(node, "/slackwater/authority"), run_too(other, "/slackwater/authority");
  const auto not_the_other = pause_too.call({});
  expect(not_the_other && !not_the_other->success() &&
             not_the_other->message().find("the run is held by dds ") == 0,
         "who pauses it first has it: " + (not_the_other ? not_the_other->message() : ""));
  const auto run_given = run_authority.call(give);
  expect(run_given && run_given->success(), "and gives it back");
  const auto helm = authority.call(ask);
  expect(helm && helm->success(), "while it is at a helm");
  const auto unasked = pause_too.call({});
  expect(unasked && !unasked->success() &&
             unasked->message().find("ask for the run before you pause it") != std::string::npos,
         "nobody else pauses it unasked: " + (unasked ? unasked->message() : ""));
  const auto asked_for = run_too.call(ask);
  expect(asked_for && asked_for->success(), "but who asks for the run");
  const auto paused_too = pause_too.call({});
  expect(paused_too && paused_too->success(), "pauses it");
  const auto not_stepped = step.call(steps);
  expect(not_stepped && !not_stepped->success(), "the first does not step it then");
  Trigger resume_other(other, "/slackwater/resume");
  const auto on = resume_other.call({});
  expect(on && on->success(), "and it goes on");

  // --- handing over ---
  // A second after the last velocity the helm was free.
  const auto again = authority.call(ask);
  expect(again && again->success(), "authority is asked for again");
  Trigger allow(node, vehicle + "/allow_take_over");
  const auto allowed = allow.call({});
  expect(allowed && allowed->success(), "the holder allows a take-over");
  const auto taken = others.call(ask);
  expect(taken && taken->success(), "and the other has it");
  const auto late = authority.call(give);
  expect(late && !late->success(), "which the first can no longer give back");
  Trigger resume_mission(other, vehicle + "/resume_mission");
  const auto own = resume_mission.call({});
  expect(own && own->success(), "back on its own mission");
  std::printf("%d failed\n", failures);
  return failures == 0 ? 0 : 1;
}
