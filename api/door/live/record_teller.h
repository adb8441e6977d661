#pragma once
#include <map>
#include <string>
#include <vector>

#include "api/ask/run/scenario_run.h"
#include "api/door/live/command_door.h"

namespace slackwater::live {

/// What of a record's commands and refusals was told when its run was made again.
struct RecordTold {
  struct Share {
    std::uint64_t in_log = 0;
    std::uint64_t told = 0;
    bool operator==(const Share&) const = default;
  };
  std::map<std::string, Share> commands;  ///< by kind; some have no topic
  Share refusals;                         ///< commands that were refused
  std::uint64_t refusal_messages = 0;     ///< in which they are told

  /// "70 of 72 commands (no topic: 2 hold), 7 of 7 refusals in 3 messages"; empty: there were none.
  [[nodiscard]] std::string text() const;
};

/// Tells what clients were told and heard in a run that is made again from its record: commands as
/// they were taken, at the barrier at which the run itself told of them; refusals as the log has
/// them, each client, vehicle and reason once, with the count, at the time and in the words of the
/// last one.
class RecordTeller {
 public:
  /// @param record  outlives it
  RecordTeller(const api::RunRecord& record, CommandDoor& command_door);
  /// At a barrier, before the command door speaks.
  void hand_in(std::span<const twin::Agent> agents, double t_s);
  /// So far.
  [[nodiscard]] const RecordTold& told() const noexcept { return told_; }

 private:
  CommandDoor& command_door_;
  std::vector<const twin::Command*> commands_;       ///< as they came in
  std::vector<const twin::RefusalCount*> refusals_;  ///< by the time of the last one
  std::size_t next_command_ = 0, next_refusal_ = 0;
  RecordTold told_;
};

}  // namespace slackwater::live
