#pragma once
#include <deque>
#include <functional>
#include <mutex>
#include <string>

#include "api/door/dds/message/services.h"
#include "api/door/dds/participant.h"
#include "api/door/live/command_door.h"
#include "api/door/live/navigate_action.h"
#include "api/door/live/spawn_service.h"
#include "twin/run/run_control.h"

namespace slackwater::live {

/// What the door needs of a run.
struct DoorRun {
  twin::RunControl& control;
  const twin::Environment& environment;
  RunPlace place;
  std::function<std::uint64_t()> steps_made;  ///< for any thread
  const twin::NewcomerYard& newcomer_yard;
  std::string site;  ///< a token of ROS
};

/// The command topics and services of a run on DDS, as the table "Slackwater's names on DDS" has
/// them.
///
/// `open`, `speak` and `end_run` are for the thread of the run.
class DdsDoor {
 public:
  DdsDoor(dds::Participant& participant, Stream& stream, CommandDoor& command_door, DoorRun run);

  /// The next vehicle of the run.
  void open(const std::string& name);
  void speak(std::span<const twin::AgentState> states, double t_s);
  /// The run is over: who still waits for something is told that it will not come.
  void end_run(double t_s);

 private:
  using Handler = std::function<dds::Bytes(dds::Payload, const std::string& client)>;
  /// A service that answers at once. @param refusal  the answer to a request that is none
  void serve(const std::string& name, const char* type, Handler handler,
             std::function<dds::Bytes(const std::string&)> refusal);
  void open_run_services();
  void open_topics(const std::string& name, std::size_t vehicle);
  void open_vehicle_services(const std::string& name, std::size_t vehicle);
  void take_step(dds::Payload request, const std::string& client, const dds::Answer& answer);

  dds::Participant& participant_;
  Stream& stream_;
  CommandDoor& command_door_;
  DoorRun run_;
  SpawnService spawn_;
  std::deque<NavigateAction> actions_;  ///< of each vehicle
  struct WaitingStep {
    std::uint64_t until = 0;  ///< so many the run has made
    dds::Answer answer;
  };
  std::mutex mutex_;
  std::vector<WaitingStep> waiting_;
};

}  // namespace slackwater::live
