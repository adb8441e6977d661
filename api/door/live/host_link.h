#pragma once
#include <chrono>
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
/// | agent   | `.../observation`     | `.../command`          | see below                 |
/// | physics | `.../physics_input`   | `.../physics_output`   | taken back at once        |
///
/// An agent that is late is waited for once: the steps from then on go without it, its vehicle by
/// what it was told last, until the agent answers something. One that lies, has missed five answers
/// in a row or is silent for as long is taken off. All agents of a step are asked before the first
/// is waited for. Who leaves (role 0), closes its writer or is gone from the domain is not waited
/// for any longer. Whoever is taken from is named to `on_trouble`.
///
/// Discovery finds a client's reader a little later than its request: what it is told before it
/// never gets. It is told, and waited for, from the first step that finds it listening; one that
/// does not listen for five seconds is taken off.
class HostLink {
 public:
  HostLink(dds::Participant& participant, twin::Run& run, twin::RunControl& control,
           CommandDoor& command_door, const RunPlace& place, HostRule rule,
           std::function<void(const std::string&)> on_trouble);

  /// The next vehicle of the run.
  void open(const std::string& name);

 private:
  using WallTime = std::chrono::steady_clock::time_point;
  /// Of one that was taken.
  struct Beginning {
    WallTime taken{};
    bool listens = false;  ///< it was found to, once
  };
  enum class Ear { listens, not_yet, never };
  struct Host {
    std::string name;
    dds::Participant::WriterId answer = 0, observation = 0, input = 0;
    std::string agent, physics;  ///< clients; empty: none
    Beginning of_agent, of_physics;
    double agent_timeout_s = 0, physics_timeout_s = 0;
    int missed = 0;  ///< answers of the agent, in a row
    /// Since when it is not waited for, until it answers; nothing: it is.
    std::optional<WallTime> behind_since{};
    bool is_ending = false;  ///< physics that are taken back with the next step
    LockStep<dds::AgentAsked> from_agent;
    LockStep<dds::PhysicsMade> from_physics;
  };
  /// @return what speaks against it
  [[nodiscard]] std::optional<std::string> take(std::size_t vehicle, const dds::HostAsked& asked,
                                                const std::string& client);
  [[nodiscard]] std::optional<std::string> leave(std::size_t vehicle, const std::string& client);
  void lose(const std::string& client);
  void take_command(Host& host, dds::Payload message, const std::string& client);
  [[nodiscard]] Ear ear_of(dds::Participant::WriterId writer, const std::string& client,
                           Beginning& beginning) const;
  void ask_agents(const twin::StepTime& time);
  /// @return whether its answer to the step is to be waited for
  [[nodiscard]] bool ask_agent(std::size_t vehicle, const twin::StepTime& time);
  void wait_for_agent(std::size_t vehicle, WallTime asked);
  void note_missed(std::size_t vehicle);
  [[nodiscard]] std::optional<twin::VehicleState<double>> ask_physics(std::size_t vehicle,
                                                                      const twin::HostedStep& step);
  /// Why it is taken off, and whether that is a failure, for which the rule is.
  struct Ending {
    std::string why;
    bool has_failed = true;
  };
  void drop_agent(std::size_t vehicle, const Ending& ending);
  void drop_physics(std::size_t vehicle, const Ending& ending);
  void begin_physics(std::size_t vehicle, const twin::StepTime& time);
  /// Theirs from this step on, or ours again.
  void hand_physics(std::size_t vehicle, const std::string& by, bool is_hosted,
                    const twin::StepTime& time);
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
/// @throws Error(invalid_input) for a kind that there is not, and for another number of actuators
/// than the vehicle has
[[nodiscard]] std::optional<twin::CommandWhat> command_of(const dds::AgentAsked& asked,
                                                          const twin::Vehicle& vehicle);

}  // namespace slackwater::live
