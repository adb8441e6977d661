#include "api/show/morning/morning_text.h"

#include <array>
#include <cctype>

#include "api/ask/windows/worth.h"
#include "api/show/morning/morning_clock.h"
#include "api/show/morning/task_words.h"
#include "api/show/windows/windows_answer.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

constexpr std::size_t most_lines = 8;

/// Why some best start is no go, whatever its probability.
std::string unforecast_text(const Morning& morning) {
  for (const TaskWindows& task : morning.windows.tasks) {
    const TaskStart* best = best_of(task);
    if (best != nullptr && !best->unforecast.empty())
      return " No go without a forecast: " + best->unforecast + ".";
  }
  return {};
}

}  // namespace

std::string headline_of(const Morning& morning) {
  std::array<std::size_t, 3> counts{};
  for (const TaskWindows& task : morning.windows.tasks)
    ++counts.at(static_cast<std::size_t>(task.verdict));
  const std::size_t left_out = morning.windows.left_out.size();
  const std::size_t all = morning.windows.tasks.size() + left_out;
  const std::string when = " " + MorningClock(morning).span();
  if (counts[0] == all)
    return (all == 1 ? std::string("Go for the task") : formatted("Go for all {} tasks", all)) +
           when + ".";
  std::string text = counts[0] > 0 ? formatted("Go for {} of {} tasks", counts[0], all) + when
                                   : formatted("No go for any of {} tasks", all) + when;
  std::vector<std::string> others;
  if (counts[1] > 0) others.push_back(formatted("{} marginal", counts[1]));
  if (counts[2] > 0) others.push_back(formatted("{} no-go", counts[2]));
  if (left_out > 0) others.push_back(formatted("{} not worked out", left_out));
  return text + "; " + joined(others, ", ") + "." + unforecast_text(morning);
}

std::string today_headline_of(const Morning& morning) {
  if (!morning.today) return {};
  std::string text = headline_of(today_of(morning));
  text.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(text.front())));
  return "Today: " + text;
}

namespace {

/// One line: the headline, and the first two tasks that are worth a thought.
std::string today_text(const Morning& morning) {
  if (!morning.today) return {};
  const Morning today = today_of(morning);
  const MorningClock clock(today);
  std::string text = today_headline_of(morning);
  std::size_t told = 0;
  for (const TaskWindows* task : by_verdict(today)) {
    if (task->verdict == twin::Verdict::no_go || told == 2) break;
    text += (told++ == 0 ? " " : "; ") + task->name + " at " + joined(task->turbines, ", ") + ": " +
            best_text(*task, clock);
  }
  return text + (told > 0 ? ".\n" : "\n");
}

}  // namespace

std::string morning_text(const Morning& morning) {
  const MorningClock clock(morning);
  const std::vector<const TaskWindows*> tasks = by_verdict(morning);
  // One more than there is room for is better named than counted.
  const std::size_t room =
      most_lines - (morning.windows.left_out.empty() ? 0 : 1) - (morning.today ? 1 : 0);
  const std::size_t shown = tasks.size() > room ? room - 1 : tasks.size();
  std::string text = today_text(morning) + headline_of(morning) + " " + clock.note() + "\n";
  for (std::size_t i = 0; i < shown; ++i) {
    const TaskWindows& task = *tasks[i];
    const TaskStart* best = best_of(task);
    text += "  " + verdict_first(task) + task.name + " at " + joined(task.turbines, ", ") + ": " +
            best_text(task, clock);
    if (task.verdict != twin::Verdict::go && best != nullptr)
      text += "; " + stopping_text(task, *best, clock);
    text += "\n";
  }
  if (!morning.windows.left_out.empty())
    text += "  not worked out: " + morning.windows.left_out.front().task +
            (morning.windows.left_out.size() > 1
                 ? formatted(" and {} more", morning.windows.left_out.size() - 1)
                 : std::string()) +
            "; the page says why\n";
  if (shown < tasks.size())
    text += formatted("  and {} more with no better verdict\n", tasks.size() - shown);
  return text;
}

}  // namespace slackwater::api
