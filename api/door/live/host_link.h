#pragma once
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include "api/door/dds/message/hosted.h"
#include "api/door/dds/participant.h"
#include "api/door/live/command_door.h"
#include "api/door/live/lock_step.h"
#include "twin/run/run.h"

namespace slackwater::live {

/// What becomes of a vehicle whose host is gone, lies or is late.
enum class HostRule {
  take_back,  ///< an agent's: it holds, later goes home; of physics: ours go on from where it is
  halt,       ///< the run is paused, for people to look
};

/// Lets other processes across the barrier: who asks on `/NAME/host/request`
/// (slackwater_msgs/msg/HostRequest) is told on `/NAME/host/answer` whether it is the agent of the
/// vehicle, or makes its physics, from now on. Each step then waits for its answer, for no longer
/// than it asked for:
///
/// | role    | is told on            | answers on             | late or lying             |
/// |---------|-----------------------|------------------------|---------------------------|
/// | agent   | `.../observation`     | `.../command`          | lies, 5 late: taken off   |
/// | physics | `.../physics_input`   | `.../physics_output`   | taken back at once        |
///
/// Whoever is taken from is named to `on_trouble`.
class HostLink {
 public:
  HostLink(dds::Participant& participant, twin::Run& run, twin::RunControl& control,
           CommandDoor& command_door, const RunPlace& place, HostRule rule,
           std::function<void(const std::string&)> on_trouble);

  /// The next vehicle of the run.
  void open(const std::string& name);

 private:
  struct Host {
    std::string name;
    dds::Participant::WriterId answer = 0, observation = 0, input = 0;
    std::string agent, physics;  ///< clients; empty: none
    double agent_timeout_s = 0, physics_timeout_s = 0;
    int missed = 0;          ///< answers of the agent, in a row
    bool is_ending = false;  ///< physics that are taken back with the next step
    LockStep<dds::AgentAsked> from_agent;
    LockStep<dds::PhysicsMade> from_physics;
  };
  /// @return what speaks against it
  [[nodiscard]] std::optional<std::string> take(std::size_t vehicle, const dds::HostAsked& asked,
                                                const std::string& client);
  void lose(const std::string& client);
  void ask_agents(const twin::StepTime& time);
  void ask_agent(std::size_t vehicle, const twin::StepTime& time);
  [[nodiscard]] std::optional<twin::VehicleState<double>> ask_physics(std::size_t vehicle,
                                                                      const twin::HostedStep& step);
  /// @return answers of the agent that did not come, in a row
  [[nodiscard]] int count_missed(Host& host, bool has_missed);
  void drop_agent(std::size_t vehicle, const std::string& why);
  void drop_physics(std::size_t vehicle, const std::string& why);
  void end_physics(std::size_t vehicle, std::uint64_t step, double t_s);
  void tell(const std::string& text) const;

  dds::Participant& participant_;
  twin::Run& run_;
  twin::RunControl& control_;
  CommandDoor& command_door_;
  RunPlace place_;
  HostRule rule_;
  std::function<void(const std::string&)> on_trouble_;
  std::mutex mutex_;  ///< of who hosts what
  std::deque<Host> hosts_;
};

/// What an agent asked for, as a command; nothing where it asks for nothing.
/// @throws Error(invalid_input) for a kind that there is not
[[nodiscard]] std::optional<twin::CommandWhat> command_of(const dds::AgentAsked& asked);
/// The same as the message of the command topic that it could have come on, for recordings; empty
/// where there is no such topic.
[[nodiscard]] dds::Bytes heard_of(const dds::AgentAsked& asked);

}  // namespace slackwater::live
