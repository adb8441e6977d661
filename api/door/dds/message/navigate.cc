#include "api/door/dds/message/navigate.h"

#include "api/door/dds/message/cdr.h"
#include "api/door/dds/message/path_message.h"
#include "slackwater_msgs.h"

namespace slackwater::dds {
namespace {

/// slackwater_msgs/action/Navigate_SendGoal_Request.
struct SendGoalRequest {
  unique_identifier_msgs::msg::UUID id;
  PathAsked path;

  void deserialize(eprosima::fastcdr::Cdr& cdr) {
    cdr >> id;
    path.deserialize(cdr);
  }
};

action_msgs::msg::GoalInfo info_message(const GoalInfo& info) {
  action_msgs::msg::GoalInfo message;
  message.goal_id().uuid(info.id);
  message.stamp(time_message(info.accepted_at));
  return message;
}

}  // namespace

GoalAsked read_send_goal(Payload request) {
  const auto asked = decoded<SendGoalRequest>(request);
  return {asked.id.uuid(), asked.path.places_m};
}

Bytes send_goal_reply(bool accepted, const Stamp& stamp) {
  slackwater_msgs::action::Navigate_SendGoal_Response reply;
  reply.accepted(accepted);
  reply.stamp(time_message(stamp));
  return encoded(reply);
}

GoalInfo read_cancel_goal(Payload request) {
  const auto asked = decoded<action_msgs::srv::CancelGoal_Request>(request);
  return {asked.goal_info().goal_id().uuid(), stamp_of(asked.goal_info().stamp())};
}

Bytes cancel_goal_reply(CancelAnswer answer, std::span<const GoalInfo> canceling) {
  action_msgs::srv::CancelGoal_Response reply;
  reply.return_code(static_cast<std::int8_t>(answer));
  for (const GoalInfo& goal : canceling) reply.goals_canceling().push_back(info_message(goal));
  return encoded(reply);
}

GoalId read_get_result(Payload request) {
  return decoded<slackwater_msgs::action::Navigate_GetResult_Request>(request).goal_id().uuid();
}

Bytes result_reply(GoalStatus status, bool success, const std::string& message) {
  slackwater_msgs::action::Navigate_GetResult_Response reply;
  reply.status(static_cast<std::int8_t>(status));
  reply.result().success(success);
  reply.result().message(message);
  return encoded(reply);
}

Bytes unknown_result_reply() {
  return encoded(slackwater_msgs::action::Navigate_GetResult_Response());
}

Bytes feedback(const GoalId& id, std::uint32_t waypoint, double distance_m) {
  slackwater_msgs::action::Navigate_FeedbackMessage message;
  message.goal_id().uuid(id);
  message.feedback().waypoint(waypoint);
  message.feedback().distance_m(distance_m);
  return encoded(message);
}

Bytes goal_status(std::span<const GoalState> goals) {
  action_msgs::msg::GoalStatusArray message;
  for (const GoalState& state : goals) {
    action_msgs::msg::GoalStatus status;
    status.goal_info(info_message(state.goal));
    status.status(static_cast<std::int8_t>(state.status));
    message.status_list().push_back(std::move(status));
  }
  return encoded(message);
}

}  // namespace slackwater::dds
