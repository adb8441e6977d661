#include "api/morning/task_words.h"

#include <cmath>

#include "api/morning/morning_clock.h"
#include "api/rehearse/rehearsal_json.h"
#include "api/windows/windows_answer.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

std::string percent(double probability) { return formatted("{:.0f} %", 100 * probability); }

std::string run_text(const TaskWindows& task, const twin::StartWindow& window,
                     const MorningClock& clock) {
  return clock(task.starts[window.first].start, task.starts[window.last].start);
}

/// "06:00–09:30, 11:00": the starts whose chance is at least so much.
std::string starts_from(const TaskWindows& task, double least, const MorningClock& clock) {
  std::vector<std::string> parts;
  for (std::size_t first = 0; first < task.starts.size(); ++first) {
    const auto is_open = [&](std::size_t i) {
      return task.starts[i].forbidden.empty() && worth_of(task.starts[i]) >= least;
    };
    if (!is_open(first)) continue;
    std::size_t last = first;
    while (last + 1 < task.starts.size() && is_open(last + 1)) ++last;
    parts.push_back(clock(task.starts[first].start, task.starts[last].start));
    first = last;
  }
  return joined(parts, ", ");
}

/// "Go: start 04:30–05:00. Marginal: 00:00–16:00 (52 to 93 %)."
std::string windows_line(const Morning& morning, const TaskWindows& task,
                         const MorningClock& clock) {
  const twin::VerdictRule& rule = morning.question.windows.rule;
  const std::string go = starts_from(task, rule.go, clock);
  std::string text = go.empty() ? "" : "Go: start " + go + ". ";
  std::vector<std::string> parts;
  for (const twin::StartWindow& window : task.windows) {
    if (window.least >= rule.go) continue;
    const std::string least = percent(window.least), most = percent(window.most);
    parts.push_back(run_text(task, window, clock) + " (" +
                    (least == most ? most : formatted("{:.0f} to ", 100 * window.least) + most) +
                    ")");
  }
  if (!parts.empty())
    text += (go.empty() ? "Marginal: start " : "With less: ") + joined(parts, ", ") + ".";
  return text;
}

std::string best_line(const Morning& morning, const TaskWindows& task, const MorningClock& clock) {
  const TaskStart* best = best_of(task);
  if (best == nullptr) return "There is no start.";
  std::string text = task.windows.empty() ? "No start is likely; the best is " : "Best ";
  text += clock(best->start) + ": " + percent(best->probability) +
          formatted(" ({:.0f} to {:.0f})", 100 * best->interval.low, 100 * best->interval.high);
  if (worth_of(*best) < best->probability) text += ", as flown " + percent(worth_of(*best));
  const bool is_exceeded = best->chance.binding && best->chance.binding->is_exceeded;
  return text +
         (task.windows.empty() ? ". What stops it: "
          : is_exceeded        ? ". What threatens it: "
                               : ". What comes nearest: ") +
         binding_text(task, *best, futures_of(morning), clock) + ".";
}

/// Of the starts that were flown the best.
std::string flown_line(const TaskWindows& task, const MorningClock& clock) {
  const TaskStart* best = best_flown(task);
  if (best == nullptr) return {};
  std::size_t flown = 0, flights = 0;
  for (const TaskStart& start : task.starts) {
    flown += start.twin ? 1 : 0;
    flights += start.twin ? start.twin->flights : 0;
  }
  const TwinChance& twin = *best->twin;
  std::string text = formatted("Flown {} times at {} starts; best ", flights, flown) +
                     clock(best->start) +
                     formatted(", {} of {} done ({:.0f} to {:.0f} %)",
                               std::lround(twin.probability * static_cast<double>(twin.flights)),
                               twin.flights, 100 * twin.interval.low, 100 * twin.interval.high);
  const auto low = quantile_of(twin.duration_s, 0.1), middle = quantile_of(twin.duration_s, 0.5),
             high = quantile_of(twin.duration_s, 0.9);
  if (low && middle && high)
    text += formatted(", {:.0f} min ({:.0f} to {:.0f})", *middle / 60, *low / 60, *high / 60);
  const auto energy = quantile_of(twin.energy_wh, 0.9);
  if (energy && *energy > 0) text += formatted(", 9 of 10 within {:.0f} Wh", *energy);
  if (!twin.stopped_by.empty()) text += "; stopped by " + twin.stopped_by;
  return text + ".";
}

std::string rule_line(const TaskWindows& task, const MorningClock& clock) {
  const auto starts = [&](const std::vector<twin::StartWindow>& windows) {
    std::vector<std::string> parts;
    for (const twin::StartWindow& window : windows) parts.push_back(run_text(task, window, clock));
    return parts.empty() ? std::string("no start") : joined(parts, ", ");
  };
  std::string text = "The central forecast alone: " + starts(task.by_threshold);
  return text +
         (task.by_alpha ? "; with the margins of practice: " + starts(*task.by_alpha)
                        : "; practice says nothing: " + task.no_alpha) +
         ".";
}

}  // namespace

std::string where_and_how_long(const TaskWindows& task) {
  return joined(task.turbines, ", ") +
         formatted(", {:.1f} h and {:.1f} h in hand", task.planned_s / 3600,
                   task.contingency_s / 3600) +
         (task.is_split ? formatted(", in visits of {:.1f} h and more", task.least_visit_s / 3600)
                        : std::string());
}

std::string best_text(const TaskWindows& task, const std::function<std::string(UtcTime)>& clock) {
  const TaskStart* best = best_of(task);
  if (best == nullptr) return "no start";
  return "best " + clock(best->start) + ", " + percent(worth_of(*best));
}

const TaskStart* best_flown(const TaskWindows& task) {
  const TaskStart* best = nullptr;
  for (const TaskStart& start : task.starts)
    if (start.twin && (best == nullptr || start.twin->interval.low > best->twin->interval.low))
      best = &start;
  return best;
}

std::vector<std::string> task_words(const Morning& morning, const TaskWindows& task) {
  const MorningClock clock(morning);
  std::vector<std::string> lines;
  if (!task.windows.empty()) lines.push_back(windows_line(morning, task, clock));
  lines.push_back(best_line(morning, task, clock));
  if (std::string flown = flown_line(task, clock); !flown.empty())
    lines.push_back(std::move(flown));
  lines.push_back(rule_line(task, clock));
  if (!task.not_checked.empty())
    lines.push_back("Not checked: " + joined(task.not_checked, "; ") + ".");
  for (const std::string& value : task.assumed)
    lines.push_back("Assumed, not forecast: " + value + ".");
  lines.insert(lines.end(), task.notes.begin(), task.notes.end());
  return lines;
}

std::string rules_text(const Morning& morning) {
  const WindowsQuestion& question = morning.question.windows;
  bool is_flown = false;
  for (const TaskWindows& task : morning.windows.tasks)
    is_flown = is_flown || best_flown(task) != nullptr;
  return formatted(
             "Height: the chance that all limits hold from a start to the way home, as {} futures "
             "of the forecast say. Full: {:.0f} % or more, go; hatched: {:.0f} % or more, "
             "marginal; pale: less. ",
             futures_of(morning), 100 * question.rule.go, 100 * question.rule.marginal) +
         (is_flown ? formatted("Rings: the share of flights that were done; from {} flights on a "
                               "start is worth no more than they say. ",
                               flights_that_count)
                   : std::string()) +
         "Grey behind: the sun is down. Practice: " + question.practice.name() + ". " +
         MorningClock(morning).note();
}

}  // namespace slackwater::api
