#include "api/ask/morning/morning_decisions.h"

#include "api/ask/decisions/decide.h"

namespace slackwater::api {
namespace {

/// Of each task of the windows its name there, by the one that it is found by.
std::map<std::string, std::string> names_in(const WindowsAnswer& windows) {
  std::map<std::string, std::string> names;
  for (const TaskWindows& task : windows.tasks) names[lasting_name(task.id)] = task.id;
  for (const TaskLeftOut& left : windows.left_out) names[lasting_name(left.task)] = left.task;
  return names;
}

}  // namespace

std::optional<MorningDecisions> morning_decisions(const WindowsQuestion& question,
                                                  const WindowsAnswer& windows, UtcTime from,
                                                  UtcTime known_by,
                                                  const std::filesystem::path& store_folder) {
  if (!std::filesystem::exists(store_folder / "catalogue.sqlite")) return std::nullopt;
  DecisionsQuestion asked;
  asked.windows.site = question.site;
  asked.windows.zone = question.zone;
  asked.windows.shift = question.shift;
  asked.windows.practice = question.practice;
  asked.windows.threads = question.threads;
  asked.from = from - record_goes_back;
  asked.known_by = known_by;
  DecisionsAnswer answer = decisions_of(asked, store_folder);
  if (answer.decisions.empty()) return std::nullopt;
  const std::map<std::string, std::string> names = names_in(windows);
  MorningDecisions decisions;
  decisions.record = answer.record;
  for (DecisionAnswer& one : answer.decisions) {
    if (!one.counts || one.row.start < from || one.row.start >= windows.to) continue;
    const auto name = names.find(one.row.task);
    decisions.by_task[name == names.end() ? one.row.task : name->second].push_back(std::move(one));
  }
  return decisions;
}

}  // namespace slackwater::api
