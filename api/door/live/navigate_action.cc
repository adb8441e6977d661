#include "api/door/live/navigate_action.h"

#include <algorithm>
#include <utility>

#include "api/door/live/reroute.h"

namespace slackwater::live {
NavigateAction::NavigateAction(dds::Participant& participant, Stream& stream,
                               CommandDoor& command_door, const RunPlace& place,
                               const std::string& name, std::size_t vehicle)
    : stream_(stream), command_door_(command_door), place_(place), vehicle_(vehicle) {
  const std::string action = "/" + name + "/navigate/_action/";
  feedback_ = stream.open(action + "feedback", "slackwater_msgs/action/Navigate_FeedbackMessage",
                          state_quality);
  status_ = stream.open(action + "status", "action_msgs/msg/GoalStatusArray", latched_quality);
  participant.serve({action + "send_goal", "slackwater_msgs/action/Navigate_SendGoal"},
                    [this](dds::Payload request, const std::string& client,
                           const dds::Answer& answer) { take_goal(request, client, answer); });
  participant.serve({action + "cancel_goal", "action_msgs/srv/CancelGoal"},
                    [this](dds::Payload request, const std::string& client,
                           const dds::Answer& answer) { take_cancel(request, client, answer); });
  participant.serve({action + "get_result", "slackwater_msgs/action/Navigate_GetResult"},
                    [this](dds::Payload request, const std::string&, const dds::Answer& answer) {
                      take_result(request, answer);
                    });
}

NavigateAction::Goal* NavigateAction::active() {
  for (Goal& goal : goals_)
    if (!dds::is_over(goal.is.status)) return &goal;
  return nullptr;
}

NavigateAction::Goal* NavigateAction::find(const dds::GoalId& id) {
  const auto found = std::find_if(goals_.begin(), goals_.end(),
                                  [&](const Goal& goal) { return goal.is.goal.id == id; });
  return found == goals_.end() ? nullptr : &*found;
}

void NavigateAction::end(Goal& goal, dds::GoalStatus status, const std::string& message) {
  goal.is.status = status;
  goal.message = message;
  has_changed_ = true;
  for (const dds::Answer& answer : goal.waiting)
    answer(dds::result_reply(status, status == dds::GoalStatus::succeeded, message));
  goal.waiting.clear();
}

void NavigateAction::take_goal(dds::Payload request, const std::string& client,
                               const dds::Answer& answer) {
  const double now_s = command_door_.arbiter().time_s();
  const dds::Stamp now = dds::stamp_of(place_.epoch, now_s);
  const auto refuse = [&] { answer(dds::send_goal_reply(false, now)); };
  dds::GoalAsked asked;
  try {
    asked = dds::read_send_goal(request);
  } catch (const std::exception& e) {
    command_door_.refuse(client, vehicle_, e.what());
    return refuse();
  }
  {
    const std::lock_guard lock(mutex_);
    if (find(asked.id) != nullptr) {
      command_door_.refuse(client, vehicle_,
                           "a goal of this id was sent before; give each its own");
      return refuse();
    }
  }
  const twin::Reroute reroute = reroute_to(asked.places_m);
  if (reroute.waypoints.empty()) {
    command_door_.refuse(client, vehicle_,
                         "found a goal without a place; give its path at least one pose");
    return refuse();
  }
  // Without the lock, for which a barrier waits: a long path takes its time to be looked at.
  const Submitted submitted = command_door_.submit(client, vehicle_, reroute,
                                                   dds::active_waypoints(reroute.waypoints, now));
  if (submitted.refusal) return refuse();
  const std::lock_guard lock(mutex_);
  if (Goal* before = active()) end(*before, dds::GoalStatus::aborted, "another goal replaced it");
  if (goals_.size() >= most_goals) goals_.pop_front();
  Goal& goal = goals_.emplace_back();
  goal.is = {{asked.id, now}, dds::GoalStatus::executing};
  goal.client = client;
  goal.number = submitted.number;
  goal.waypoints = reroute.waypoints.size();
  has_changed_ = true;
  answer(dds::send_goal_reply(true, now));
}

void NavigateAction::take_cancel(dds::Payload request, const std::string& client,
                                 const dds::Answer& answer) {
  dds::GoalInfo asked;
  try {
    asked = dds::read_cancel_goal(request);
  } catch (const std::exception& e) {
    command_door_.refuse(client, vehicle_, e.what());
    return answer(dds::cancel_goal_reply(dds::CancelAnswer::rejected, {}));
  }
  const std::lock_guard lock(mutex_);
  const bool asks_all = asked.id == dds::GoalId{};
  Goal* goal = asks_all ? active() : find(asked.id);
  const bool is_too_new =
      asks_all && goal != nullptr && asked.accepted_at != dds::Stamp{} &&
      dds::nanoseconds_of(goal->is.goal.accepted_at) > dds::nanoseconds_of(asked.accepted_at);
  if (goal == nullptr || is_too_new) {
    return answer(dds::cancel_goal_reply(
        asks_all ? dds::CancelAnswer::none : dds::CancelAnswer::unknown_goal, {}));
  }
  if (dds::is_over(goal->is.status))
    return answer(dds::cancel_goal_reply(dds::CancelAnswer::is_over, {}));
  if (command_door_.submit(client, vehicle_, twin::HoldHere{}).refusal)
    return answer(dds::cancel_goal_reply(dds::CancelAnswer::rejected, {}));
  const dds::GoalInfo canceling = goal->is.goal;
  answer(dds::cancel_goal_reply(dds::CancelAnswer::none, {&canceling, 1}));
  end(*goal, dds::GoalStatus::canceled, "cancelled: the vehicle holds where it is");
}

void NavigateAction::take_result(dds::Payload request, const dds::Answer& answer) {
  dds::GoalId id;
  try {
    id = dds::read_get_result(request);
  } catch (const std::exception&) {
    return answer(dds::unknown_result_reply());
  }
  const std::lock_guard lock(mutex_);
  Goal* goal = find(id);
  if (goal == nullptr) return answer(dds::unknown_result_reply());
  if (!dds::is_over(goal->is.status)) {
    if (goal->waiting.size() >= most_waiting) return answer(dds::unknown_result_reply());
    return goal->waiting.push_back(answer);
  }
  answer(dds::result_reply(goal->is.status, goal->is.status == dds::GoalStatus::succeeded,
                           goal->message));
}

void NavigateAction::follow(Goal& goal, const twin::AgentState& state, const dds::Stamp& stamp,
                            double t_s) {
  const twin::HelmState& helm = state.helm;
  if (state.halt != twin::Halt::none) {
    end(goal, dds::GoalStatus::aborted,
        "the vehicle has stopped: " + std::string(twin::name_of(state.halt)));
  } else if (command_door_.arbiter().taken(vehicle_) != goal.number) {
    end(goal, dds::GoalStatus::aborted, "another command replaced it");
  } else if (command_door_.arbiter().is_waiting(vehicle_)) {
    // Accepted while a step was under way: what the vehicle does is still of before.
  } else if (helm.mode == twin::HelmMode::hold && helm.cause == twin::HelmCause::list_done) {
    end(goal, dds::GoalStatus::succeeded, "at the last place");
  } else if (helm.mode != twin::HelmMode::waypoints) {
    end(goal, dds::GoalStatus::aborted,
        std::string("the vehicle does something else: ") + twin::name_of(helm.mode) + ", " +
            twin::name_of(helm.cause));
  } else if (constexpr double every_s = 0.2; t_s >= told_s_ + every_s - 1e-6) {
    told_s_ = t_s;
    if (stream_.is_wanted(feedback_)) say_feedback(goal, state, stamp);
  }
}

void NavigateAction::say_feedback(const Goal& goal, const twin::AgentState& state,
                                  const dds::Stamp& stamp) {
  const twin::Route& route = state.helm.way.route;
  const std::size_t left = std::min(waypoints_left(state).size(), goal.waypoints);
  const double distance_m =
      route.is_done() ? 0 : twin::length_of(route.to().position_m - state.vehicle.body.position_m);
  stream_.publish(feedback_, stamp,
                  dds::feedback(goal.is.goal.id, static_cast<std::uint32_t>(goal.waypoints - left),
                                distance_m));
}

void NavigateAction::speak(const twin::AgentState& state, double t_s) {
  const dds::Stamp stamp = dds::stamp_of(place_.epoch, t_s);
  const std::lock_guard lock(mutex_);
  if (Goal* goal = active()) follow(*goal, state, stamp, t_s);
  say_status(stamp);
}

void NavigateAction::say_status(const dds::Stamp& stamp) {
  if (!std::exchange(has_changed_, false)) return;
  std::vector<dds::GoalState> states;
  for (const Goal& goal : goals_) states.push_back(goal.is);
  stream_.publish(status_, stamp, dds::goal_status(states));
}

void NavigateAction::end_run(double t_s) {
  const std::lock_guard lock(mutex_);
  if (Goal* goal = active()) end(*goal, dds::GoalStatus::aborted, "the run is over");
  say_status(dds::stamp_of(place_.epoch, t_s));
}

}  // namespace slackwater::live
