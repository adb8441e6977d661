#include "api/show/morning/help_words.h"

#include "api/show/morning/morning_clock.h"
#include "api/show/rehearse/advice_report.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

/// A short list: what changes the answer most.
constexpr std::size_t most_told = 3;

std::string relief_line(const TaskWindows& task, const MorningClock& clock) {
  std::vector<std::string> parts;
  for (const Relief& relief : task.reliefs) {
    if (parts.size() == most_told) break;
    parts.push_back("\"" + text_of(task.limits[relief.limit]) +
                    formatted("\": {:.0f} % at ", 100 * relief.probability) + clock(relief.start));
  }
  if (parts.empty()) return {};
  return "What would help: the best start without the limit " + joined(parts, "; without ") + ".";
}

/// Why no relief is told, where more than one limit stands in the way of a no-go.
std::string no_relief_line(const TaskWindows& task) {
  if (task.verdict != twin::Verdict::no_go) return {};
  for (const TaskStart& start : task.starts)
    if (start.chance.binding && start.chance.binding->is_exceeded)
      return "More than one limit stops this task: leaving out a single limit hardly improves the "
             "best start.";
  return {};
}

std::string flown_line(const FlownAdvice& advice, const MorningClock& clock) {
  std::vector<std::string> parts;
  for (const Advice& change : advice.changes)
    if (change.impossible.empty() && change.gain() > 0 && parts.size() < most_told)
      parts.push_back(text_of(change));
  const std::string of_start = "The flights of " + clock(advice.start) + " with one thing changed";
  if (!parts.empty()) return of_start + ": " + joined(parts, "; ") + ".";
  std::size_t flown = 0;
  for (const Advice& change : advice.changes) flown += change.flights > 0 ? 1 : 0;
  if (flown == 0) return {};
  return of_start + formatted(" in {} ways are not done more often.", flown);
}

}  // namespace

std::vector<std::string> help_words(const Morning& morning, const TaskWindows& task) {
  std::vector<std::string> lines;
  if (task.verdict == twin::Verdict::go) return lines;
  const MorningClock clock(morning);
  const std::string by_limits =
      task.reliefs.empty() ? no_relief_line(task) : relief_line(task, clock);
  if (!by_limits.empty()) lines.push_back(by_limits);
  if (!task.advice) return lines;
  if (const std::string flown = flown_line(*task.advice, clock); !flown.empty())
    lines.push_back(flown);
  return lines;
}

}  // namespace slackwater::api
