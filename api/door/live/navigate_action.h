#pragma once
#include <deque>
#include <mutex>
#include <string>
#include <vector>

#include "api/door/dds/message/navigate.h"
#include "api/door/dds/participant.h"
#include "api/door/live/command_door.h"

namespace slackwater::live {

/// `/NAME/navigate` of one vehicle: a path as a goal, with feedback, result and cancelling. What
/// else the vehicle is told to do, another goal or a command of any door, takes the place of the
/// one under way, which is aborted.
///
/// `speak` and `end_run` are for the thread of the run, the services for any thread.
class NavigateAction {
 public:
  NavigateAction(dds::Participant& participant, Stream& stream, CommandDoor& command_door,
                 const RunPlace& place, const std::string& name, std::size_t vehicle);

  void speak(const twin::AgentState& state, double t_s);
  /// The run is over, and with it the goal under way.
  void end_run(double t_s);

 private:
  struct Goal {
    dds::GoalState is;
    std::string client;
    std::uint64_t number = 0;  ///< of its command; see `Submitted`
    std::size_t waypoints = 0;
    std::string message;               ///< of its end
    std::vector<dds::Answer> waiting;  ///< for that
  };
  void take_goal(dds::Payload request, const std::string& client, const dds::Answer& answer);
  void take_cancel(dds::Payload request, const std::string& client, const dds::Answer& answer);
  void take_result(dds::Payload request, const dds::Answer& answer);
  /// Of the goals, the one that goes on; null: none.
  [[nodiscard]] Goal* active();
  [[nodiscard]] Goal* find(const dds::GoalId& id);
  void end(Goal& goal, dds::GoalStatus status, const std::string& message);
  /// How it goes with the one that goes on.
  void follow(Goal& goal, const twin::AgentState& state, const dds::Stamp& stamp, double t_s);
  /// Where it has changed.
  void say_status(const dds::Stamp& stamp);
  void say_feedback(const Goal& goal, const twin::AgentState& state, const dds::Stamp& stamp);

  Stream& stream_;
  CommandDoor& command_door_;
  RunPlace place_;
  std::size_t vehicle_;
  Stream::ChannelId feedback_, status_;
  std::mutex mutex_;
  std::deque<Goal> goals_;  ///< the newest last
  bool has_changed_ = true;
  double told_s_ = -1;
  static constexpr std::size_t most_goals = 100;    ///< kept for those who ask late
  static constexpr std::size_t most_waiting = 100;  ///< for the end of one
};

}  // namespace slackwater::live
