#include <algorithm>
#include <cctype>
#include <cmath>

#include "api/ask/windows/vessel_access.h"
#include "api/ask/windows/worth.h"
#include "api/show/windows/past_words.h"
#include "api/show/windows/windows_answer.h"
#include "fields/base/numbers/quantile.h"
#include "fields/base/text.h"
#include "twin/rehearse/limit_ahead.h"

namespace slackwater::api {
namespace {

/// The clock that people read: of the zone that was asked for, else UTC.
class PeoplesClock {
 public:
  PeoplesClock(const std::optional<TimeZone>& zone, UtcTime from, UtcTime to)
      : zone_(zone), has_date_(to - from > std::chrono::days(1)) {}
  [[nodiscard]] std::string operator()(UtcTime time) const {
    const std::string stamp = format_utc(local(time));
    return (has_date_ ? stamp.substr(5, 5) + " " : "") + stamp.substr(11, 5);
  }
  [[nodiscard]] std::string with_date(UtcTime time) const {
    const std::string stamp = format_utc(local(time));
    return stamp.substr(0, 10) + " " + stamp.substr(11, 5);
  }
  [[nodiscard]] std::string name(UtcTime time) const {
    return zone_ ? zone_->abbreviation_at(time) : "UTC";
  }

 private:
  [[nodiscard]] UtcTime local(UtcTime time) const {
    return zone_ ? time + zone_->offset_at(time) : time;
  }
  std::optional<TimeZone> zone_;
  bool has_date_;
};

std::string chance_text(const TaskStart& start) {
  return formatted("P {:.2f} ({:.2f} to {:.2f})", start.probability, start.interval.low,
                   start.interval.high);
}

/// "flown 12:00: P 0.92 (0.72 to 0.99) of 24 flights, done 23, seen 22, home after 55 min": of the
/// starts within a window that were flown, the best. What was seen is left out where nothing is
/// asked.
std::string flown_text(const TaskWindows& task, const twin::StartWindow& window,
                       const PeoplesClock& clock) {
  const TaskStart* best = nullptr;
  for (std::size_t i = window.first; i <= window.last; ++i) {
    const TaskStart& start = task.starts[i];
    if (start.twin && (best == nullptr || start.twin->probability > best->twin->probability))
      best = &start;
  }
  if (best == nullptr) return "";
  const TwinChance& twin = *best->twin;
  std::string text = "    flown " + clock(best->start) +
                     formatted(": P {:.2f} ({:.2f} to {:.2f}) of {} flights", twin.probability,
                               twin.interval.low, twin.interval.high, twin.flights);
  // Done is not seen: where something is to be seen, both are told.
  if (twin.p_seen)
    text += formatted(", done {}, seen {}", twin.p_done.flights, twin.p_seen->flights);
  if (const auto longest = quantile_of(twin.duration_s, 0.9))
    text += formatted(", home after {:.0f} min", *longest / 60);
  if (!twin.stopped_by.empty()) text += "; stopped: " + twin.stopped_by;
  return text + "\n";
}

std::string window_text(const TaskWindows& task, const twin::StartWindow& window,
                        const PeoplesClock& clock) {
  const TaskStart& first = task.starts[window.first];
  const TaskStart& best = task.starts[window.best];
  std::string text = "  start " + clock(first.start);
  if (window.starts() > 1) text += " to " + clock(task.starts[window.last].start);
  text += window.most - window.least < 0.005 ? formatted("   P {:.2f}", window.mean)
                                             : formatted("   P {:.2f} to {:.2f}, mean {:.2f}",
                                                         window.least, window.most, window.mean);
  text += formatted("   threshold {}/{}", window.by_threshold, window.starts());
  text +=
      task.by_alpha ? formatted("   alpha {}/{}", window.by_alpha, window.starts()) : "   alpha -";
  return text + "\n    best " + clock(best.start) + ": " + chance_text(best) + "; " +
         binding_text(task, best, clock) + "\n" + flown_text(task, window, clock);
}

std::string rule_text(const TaskWindows& task, const std::vector<twin::StartWindow>& windows,
                      const PeoplesClock& clock) {
  std::vector<std::string> parts;
  parts.reserve(windows.size());
  for (const twin::StartWindow& window : windows)
    parts.push_back(clock(task.starts[window.first].start) +
                    (window.starts() > 1 ? " to " + clock(task.starts[window.last].start) : ""));
  return parts.empty() ? "no start" : joined(parts, ", ");
}

std::string task_text(const WindowsQuestion& question, const TaskWindows& task,
                      const PeoplesClock& clock) {
  std::string text =
      verdict_first(task) + task.name + " at " + joined(task.turbines, ", ") +
      formatted(", {:.1f} h and {:.1f} h of contingency", task.planned_s / 3600,
                task.contingency_s / 3600) +
      (task.is_split ? formatted(", in visits of {:.1f} h and more", task.least_visit_s / 3600)
                     : std::string()) +
      "\n";
  for (const twin::StartWindow& window : task.windows) text += window_text(task, window, clock);
  if (const TaskStart* best = best_of(task); best != nullptr && task.windows.empty())
    text += formatted("  no start with P of {:g} or more; best ", question.rule.marginal) +
            clock(best->start) + ": " + chance_text(*best) + "\n    stopped by " +
            binding_text(task, *best, clock) + "\n";
  const bool is_less = std::any_of(task.starts.begin(), task.starts.end(), [](const auto& start) {
    return start.worth < std::min(start.probability, start.most_worth);
  });
  if (const TaskStart* best = best_of(task); best != nullptr && is_less)
    text += "  after the flights: best " + clock(best->start) +
            formatted(", worth {:.2f}; ", best->worth) + stopping_text(task, *best, clock) + "\n";
  text += "  the central forecast alone: " + rule_text(task, task.by_threshold, clock) +
          "; with alpha: " +
          (task.by_alpha ? rule_text(task, *task.by_alpha, clock) : "no answer, " + task.no_alpha) +
          "\n";
  if (const std::string past = past_text(task); !past.empty()) text += "  " + past + "\n";
  for (const std::string& limit : task.not_checked) text += "  not checked: " + limit + "\n";
  for (const std::string& value : task.assumed) text += "  assumed: " + value + "\n";
  for (const std::string& note : task.notes) text += "  " + note + "\n";
  return text;
}

/// A line a task: what is asked first of ten.
std::string summary_text(const std::vector<TaskWindows>& tasks, const PeoplesClock& clock) {
  std::string text;
  for (const TaskWindows& task : tasks) {
    const TaskStart* best = best_of(task);
    text += formatted("{:<22}  ", verdict_and_unchecked(task));
    text += best == nullptr ? std::string("no start       ")
                            : "best " + clock(best->start) + formatted("  P {:.2f}", best->worth);
    text += "  " + task.name + " at " + joined(task.turbines, ", ") + "\n";
  }
  return text + "\n";
}

}  // namespace

std::string verdict_and_unchecked(const TaskWindows& task) {
  std::string text(twin::name_of(task.verdict));
  if (task.verdict == twin::Verdict::no_go) return text;
  std::size_t unchecked = task.not_checked.size();
  if (best_flown(task) != nullptr)
    unchecked -= std::min(unchecked,
                          static_cast<std::size_t>(std::count_if(
                              task.limits.begin(), task.limits.end(), [](const TaskLimit& limit) {
                                return limit.limit && twin::only_a_run_shows(limit.limit->variable);
                              })));
  if (unchecked > 0) text += formatted(", {} unchecked", unchecked);
  return text;
}

std::string verdict_first(const TaskWindows& task) {
  const std::string text = verdict_and_unchecked(task);
  return text.find(',') == std::string::npos ? formatted("{:<9} ", text) : text + ": ";
}

std::string bound_then_text(const TaskWindows& task, const TaskStart& start) {
  if (!start.bound_then) return "";
  return text_of(*task.limits[start.chance.binding->limit].limit->table, *start.bound_then);
}

std::string binding_text(const TaskWindows& task, const TaskStart& start,
                         const std::function<std::string(UtcTime)>& clock) {
  if (!start.forbidden.empty()) return start.forbidden;
  if (!start.chance.binding) return "no limit is near";
  const twin::BindingLimit& binding = *start.chance.binding;
  std::string text = text_of(task.limits[binding.limit]);
  if (binding.is_exceeded)
    text += formatted(", exceeded at {} in {} of {} futures", clock(*start.binds_at),
                      binding.members, task.futures);
  if (!std::isnan(binding.share))
    text += formatted(binding.is_exceeded ? FormatOf<double>(" (forecast up to {:.0f} % of it)")
                                          : FormatOf<double>(", {:.0f} % of the limit reached at "),
                      100 * binding.share) +
            (binding.is_exceeded ? std::string() : clock(*start.binds_at));
  if (start.bound_then)
    text += "; the limit " + bound_then_text(task, start) + " at " + clock(*start.binds_at);
  return text;
}

std::string stopping_text(const TaskWindows& task, const TaskStart& start,
                          const std::function<std::string(UtcTime)>& clock) {
  return start.flights_stopped_by.empty() ? binding_text(task, start, clock)
                                          : "flights stopped: " + start.flights_stopped_by;
}

std::string access_text(const WindowsAnswer& answer) {
  if (answer.vessel == nullptr) return {};
  const VesselAccess& vessel = *answer.vessel;
  std::string name = vessel.name;
  name.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(name.front())));
  return "the ways of the " + name +
         formatted(" ({:.1f} h each) and the transfers ({:.0f} min each) are in the chances",
                   hours_of(vessel.passage), 60 * hours_of(vessel.transfer));
}

std::string windows_text(const WindowsQuestion& question, const WindowsAnswer& answer) {
  const PeoplesClock clock(question.zone, answer.from, answer.to);
  std::string text = std::string(twin::name_of(answer.verdict)) + ": " + answer.site_name +
                     ", starts from " + clock.with_date(answer.from) + " to " +
                     clock.with_date(answer.to) + " " + clock.name(answer.from) + "\n\n";
  if (answer.tasks.size() > 1) text += summary_text(answer.tasks, clock);
  for (const TaskWindows& task : answer.tasks) text += task_text(question, task, clock) + "\n";
  const bool has_past =
      std::any_of(answer.tasks.begin(), answer.tasks.end(),
                  [](const TaskWindows& task) { return task.calibration.starts > 0; });
  text += formatted(
      "go: a start with P of {:g} or more; marginal: of {:g}. P: that all limits hold to the way "
      "home, as the futures of the forecast say{}; in brackets its 95 % interval.\n",
      question.rule.go, question.rule.marginal,
      has_past ? ", corrected by past mornings"
               : "; no past morning of this site could be held against what came");
  if (const std::string access = access_text(answer); !access.empty()) text += access + "\n";
  text += "forecast " + answer.water.forecast_name +
          (question.waves_as_forecast ? "; waves as forecast in all futures"
                                      : "; the waves of each future have an error of their own") +
          "\nalpha: " + question.practice.name() + ", period from the " +
          (question.period_from_start ? "start" : "issue of the forecast") + "\n";
  return text;
}

}  // namespace slackwater::api
