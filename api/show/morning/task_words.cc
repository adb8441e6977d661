#include "api/show/morning/task_words.h"

#include <algorithm>
#include <cmath>

#include "api/ask/windows/worth.h"
#include "api/show/morning/help_words.h"
#include "api/show/morning/morning_clock.h"
#include "api/show/windows/past_words.h"
#include "api/show/windows/windows_answer.h"
#include "fields/base/numbers/quantile.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

std::string percent(double probability) { return formatted("{:.0f} %", 100 * probability); }

std::string run_text(const TaskWindows& task, const twin::StartWindow& window,
                     const MorningClock& clock) {
  return clock(task.starts[window.first].start, task.starts[window.last].start);
}

/// "04:30–05:00, 11:00".
std::string runs_text(const TaskWindows& task, const std::vector<WorthRun>& runs,
                      const MorningClock& clock, bool with_worth) {
  std::vector<std::string> parts;
  for (const WorthRun& run : runs) {
    std::string text = clock(task.starts[run.first].start, task.starts[run.last].start);
    const std::string least = percent(run.least), most = percent(run.most);
    if (with_worth)
      text += " (" + (least == most ? most : formatted("{:.0f} to ", 100 * run.least) + most) + ")";
    parts.push_back(text);
  }
  return joined(parts, ", ");
}

/// "Go: start 04:30–05:00. Marginal: start 00:00–04:00 (52 to 78 %)."; empty where there is
/// neither.
std::string starts_line(const Morning& morning, const TaskWindows& task,
                        const MorningClock& clock) {
  const twin::VerdictRule& rule = morning.question.windows.rule;
  const std::string go = runs_text(task, runs_of_worth(task, rule.go, 2), clock, false);
  const std::string marginal =
      runs_text(task, runs_of_worth(task, rule.marginal, rule.go), clock, true);
  std::string text = go.empty() ? "" : "Go: start " + go + ".";
  if (!marginal.empty())
    text += (go.empty() ? "Marginal: start " : " Marginal: start ") + marginal + ".";
  return text;
}

std::string best_line(const Morning& morning, const TaskWindows& task, const MorningClock& clock) {
  const TaskStart* best = best_of(task);
  if (best == nullptr) return "There is no start.";
  const bool is_likely = best->worth >= morning.question.windows.rule.marginal;
  std::string text = is_likely ? "Best " : "No start has a good chance; the best is ";
  text += clock(best->start) + ": " + percent(best->probability) +
          formatted(" (95 % interval {:.0f} to {:.0f})", 100 * best->interval.low,
                    100 * best->interval.high);
  if (best->worth < best->probability) text += ", " + percent(best->worth) + " as flown";
  const bool is_exceeded = best->chance.binding && best->chance.binding->is_exceeded;
  return text +
         (!is_likely    ? ". What stops it: "
          : is_exceeded ? ". Main risk: "
                        : ". Nearest to its limit: ") +
         stopping_text(task, *best, clock) + ".";
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
  std::string text =
      formatted("Flown {} times at {} starts; best ", flights, flown) + clock(best->start) +
      formatted(", {} of {} done", twin.p_done.flights, twin.flights) +
      (twin.p_seen ? formatted(", {} seen as asked", twin.p_seen->flights) : "") +
      formatted(" (95 % interval {}{:.0f} to {:.0f} %)", twin.p_seen ? "of both " : "",
                100 * twin.interval.low, 100 * twin.interval.high);
  const auto low = quantile_of(twin.duration_s, 0.1), middle = quantile_of(twin.duration_s, 0.5),
             high = quantile_of(twin.duration_s, 0.9);
  if (low && middle && high)
    text +=
        formatted(", {:.0f} min (8 in 10: {:.0f} to {:.0f})", *middle / 60, *low / 60, *high / 60);
  const auto energy = quantile_of(twin.energy_wh, 0.9);
  if (energy && *energy > 0) text += formatted(", 9 of 10 within {:.0f} Wh", *energy);
  if (!twin.stopped_by.empty()) text += "; stopped: " + twin.stopped_by;
  text += ".";
  // Of half of the planned time and less a reader must know which of the two was asked about.
  if (middle && *middle < 0.5 * task.planned_s)
    text += formatted(
        " The flown mission is shorter than the {:.1f} h that the sheet plans: the chance above is "
        "for all of these, the flights are of the mission alone.",
        task.planned_s / 3600);
  return text;
}

std::string rule_line(const TaskWindows& task, const MorningClock& clock) {
  const auto starts = [&](const std::vector<twin::StartWindow>& windows) {
    std::vector<std::string> parts;
    parts.reserve(windows.size());
    for (const twin::StartWindow& window : windows) parts.push_back(run_text(task, window, clock));
    return parts.empty() ? std::string("no start") : joined(parts, ", ");
  };
  std::string text = "The central forecast alone: " + starts(task.by_threshold);
  return text +
         (task.by_alpha ? "; with the usual safety margins: " + starts(*task.by_alpha)
                        : "; no answer with safety margins: " + task.no_alpha) +
         ".";
}

}  // namespace

std::string where_and_how_long(const TaskWindows& task) {
  return joined(task.turbines, ", ") +
         formatted(", {:.1f} h and {:.1f} h of reserve time", task.planned_s / 3600,
                   task.contingency_s / 3600) +
         (task.is_split ? formatted(", in visits of {:.1f} h and more", task.least_visit_s / 3600)
                        : std::string());
}

std::string best_text(const TaskWindows& task, const std::function<std::string(UtcTime)>& clock) {
  const TaskStart* best = best_of(task);
  if (best == nullptr) return "no start";
  return "best " + clock(best->start) + ", " + percent(best->worth);
}

std::vector<std::string> task_words(const Morning& morning, const TaskWindows& task) {
  const MorningClock clock(morning);
  std::vector<std::string> lines;
  if (std::string starts = starts_line(morning, task, clock); !starts.empty())
    lines.push_back(std::move(starts));
  lines.push_back(best_line(morning, task, clock));
  if (std::string flown = flown_line(task, clock); !flown.empty())
    lines.push_back(std::move(flown));
  for (std::string& line : help_words(morning, task)) lines.push_back(std::move(line));
  lines.push_back(rule_line(task, clock));
  if (std::string past = past_text(task); !past.empty()) lines.push_back(std::move(past));
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
  const bool has_past =
      std::any_of(morning.windows.tasks.begin(), morning.windows.tasks.end(),
                  [](const TaskWindows& task) { return task.calibration.starts > 0; });
  std::string access = sentence(access_text(morning.windows));
  if (!access.empty()) access += " ";
  return formatted(
             "Height: the chance that all limits hold from a start to the way home, as the "
             "futures of the forecast say{}. Full: {:.0f} % or more, go; "
             "hatched: {:.0f} % or more, "
             "marginal; pale: less. ",
             has_past ? ", corrected by past mornings" : "", 100 * question.rule.go,
             100 * question.rule.marginal) +
         (is_flown ? "Rings: the share of flights that were done, on a line as long as its 95 % "
                     "interval. Where it is clearly lower, it replaces the chance. "
                   : "") +
         access + "Grey behind: the sun is down. Practice: " + question.practice.name() + ". " +
         MorningClock(morning).note();
}

}  // namespace slackwater::api
