#include "api/door/live/record_teller.h"

#include <algorithm>

#include "fields/base/text.h"

namespace slackwater::live {
namespace {

/// What came in at a barrier was told at the next one.
bool is_due(double came_s, double t_s) { return came_s < t_s - 1e-6; }

}  // namespace

std::string RecordTold::text() const {
  std::uint64_t in_log = 0, told = 0;
  std::vector<std::string> without;
  for (const auto& [kind, share] : commands) {
    in_log += share.in_log;
    told += share.told;
    if (share.told < share.in_log)
      without.push_back(std::to_string(share.in_log - share.told) + " " + kind);
  }
  std::string text;
  if (in_log > 0) text = formatted("{} of {} commands", told, in_log);
  if (!without.empty()) text += " (no topic: " + joined(without, ", ") + ")";
  if (refusals.in_log > 0) {
    text +=
        formatted("{}{} of {} refusals in {} message{}", text.empty() ? "" : ", ", refusals.told,
                  refusals.in_log, refusal_messages, refusal_messages == 1 ? "" : "s");
    if (refusals.told < refusals.in_log) text += " (the others are of no vehicle of the run)";
  }
  return text;
}

RecordTeller::RecordTeller(const api::RunRecord& record, CommandDoor& command_door)
    : command_door_(command_door) {
  for (const twin::Command& command : record.commands) {
    commands_.push_back(&command);
    ++told_.commands[std::string(twin::name_of(command.what))].in_log;
  }
  for (const twin::RefusalCount& refusal : record.refusals) {
    refusals_.push_back(&refusal);
    told_.refusals.in_log += refusal.count;
  }
  std::stable_sort(commands_.begin(), commands_.end(),
                   [](const auto* a, const auto* b) { return a->received_s < b->received_s; });
  std::stable_sort(refusals_.begin(), refusals_.end(),
                   [](const auto* a, const auto* b) { return a->last_s < b->last_s; });
}

void RecordTeller::hand_in(std::span<const twin::Agent> agents, double t_s) {
  for (; next_command_ < commands_.size() && is_due(commands_[next_command_]->received_s, t_s);
       ++next_command_) {
    const twin::Command& command = *commands_[next_command_];
    if (command_door_.tell_taken(command.agent, command.what))
      ++told_.commands[std::string(twin::name_of(command.what))].told;
  }
  for (; next_refusal_ < refusals_.size() && is_due(refusals_[next_refusal_]->last_s, t_s);
       ++next_refusal_) {
    const twin::RefusalCount& refusal = *refusals_[next_refusal_];
    std::optional<std::size_t> vehicle = command_door_.vehicle(refusal.vehicle);
    for (std::size_t i = 0; !vehicle && i < agents.size(); ++i)
      if (agents[i].name == refusal.vehicle) vehicle = i;
    if (!vehicle) continue;
    command_door_.tell_refused(*vehicle, refusal);
    told_.refusals.told += refusal.count;
    ++told_.refusal_messages;
  }
}

}  // namespace slackwater::live
