#include "twin/risk/workability/workability.h"

#include <algorithm>
#include <map>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "twin/risk/workability/workable_starts.h"

namespace slackwater::twin {
namespace {

double ratio(std::size_t part, std::size_t of) noexcept {
  if (of == 0) return constants::nan;
  return static_cast<double>(part) / static_cast<double>(of);
}

/// What is counted in one month of one year.
struct MonthCounts {
  WindowStatistics counted;
  Waits waits;
};

/// Adds to each month the steps that ranges share with it.
void add_steps(const AccessHistory& history, const StepRanges& ranges,
               std::size_t WindowStatistics::*sum, std::vector<MonthCounts>& months) {
  std::size_t next = 0;
  for (std::size_t m = 0; m < months.size(); ++m) {
    const StepRange& month = history.months[m].steps;
    while (next < ranges.size() && ranges[next].end <= month.begin) ++next;
    for (std::size_t r = next; r < ranges.size() && ranges[r].begin < month.end; ++r)
      months[m].counted.*sum +=
          std::min(ranges[r].end, month.end) - std::max(ranges[r].begin, month.begin);
  }
}

/// Calls `add` with the month in which each range begins.
template <typename Add>
void at_the_beginning(const AccessHistory& history, const StepRanges& ranges,
                      std::vector<MonthCounts>& months, const Add& add) {
  std::size_t m = 0;
  for (const StepRange& range : ranges) {
    while (history.months[m].steps.end <= range.begin) ++m;
    add(range, months[m].counted);
  }
}

void add_window_counts(const AccessHistory& history, const StepRanges& starts,
                       std::vector<MonthCounts>& months) {
  std::size_t next = 0;
  at_the_beginning(
      history, history.windows, months, [&](const StepRange& window, WindowStatistics& counted) {
        ++counted.windows;
        counted.window_steps += window.steps();
        counted.longest_window_steps = std::max(counted.longest_window_steps, window.steps());
        while (next < starts.size() && starts[next].begin < window.begin) ++next;
        if (next < starts.size() && starts[next].begin < window.end) ++counted.workable_windows;
      });
  at_the_beginning(history, outside(history.windows, history.steps), months,
                   [](const StepRange& storm, WindowStatistics& counted) {
                     ++counted.storms;
                     counted.storm_steps += storm.steps();
                     counted.longest_storm_steps =
                         std::max(counted.longest_storm_steps, storm.steps());
                   });
}

std::vector<MonthCounts> counts_of(const AccessHistory& history, const WindowNeed& need) {
  std::vector<MonthCounts> months(history.months.size());
  const StepRanges lasting = workable_starts(history.windows, need.steps);
  const StepRanges starts = starts_for(history, need);
  add_steps(history, history.windows, &WindowStatistics::accessible_steps, months);
  add_steps(history, history.missing, &WindowStatistics::missing_steps, months);
  add_steps(history, lasting, &WindowStatistics::lasting_steps, months);
  add_steps(history, starts, &WindowStatistics::workable_starts, months);
  add_window_counts(history, starts, months);
  std::size_t next = 0;
  for (std::size_t m = 0; m < months.size(); ++m) {
    months[m].counted.steps = history.months[m].steps.steps();
    next = add_waits(history.months[m].steps, starts, next, months[m].waits);
  }
  return months;
}

/// The statistics of some months together.
WindowStatistics together(const std::vector<const MonthCounts*>& months, double step_h,
                          WaitingTimes& times) {
  WindowStatistics sum;
  sum.step_h = step_h;
  std::vector<const Waits*> waits;
  for (const MonthCounts* month : months) {
    const WindowStatistics& one = month->counted;
    for (const auto member :
         {&WindowStatistics::steps, &WindowStatistics::missing_steps,
          &WindowStatistics::accessible_steps, &WindowStatistics::workable_starts,
          &WindowStatistics::lasting_steps, &WindowStatistics::windows,
          &WindowStatistics::workable_windows, &WindowStatistics::window_steps,
          &WindowStatistics::storms, &WindowStatistics::storm_steps})
      sum.*member += one.*member;
    for (const auto member :
         {&WindowStatistics::longest_window_steps, &WindowStatistics::longest_storm_steps})
      sum.*member = std::max(sum.*member, one.*member);
    waits.push_back(&month->waits);
  }
  sum.waiting = times.of(waits, step_h);
  return sum;
}

}  // namespace

double WindowStatistics::accessibility() const noexcept { return ratio(accessible_steps, steps); }
double WindowStatistics::workability() const noexcept { return ratio(workable_starts, steps); }
double WindowStatistics::persistence() const noexcept {
  return ratio(lasting_steps, accessible_steps);
}
double WindowStatistics::mean_window_h() const noexcept {
  return ratio(window_steps, windows) * step_h;
}
double WindowStatistics::mean_storm_h() const noexcept {
  return ratio(storm_steps, storms) * step_h;
}

StepRanges starts_for(const AccessHistory& history, const WindowNeed& need) {
  const StepRanges lasting = workable_starts(history.windows, need.steps);
  return need.may_start ? common_to(lasting, *need.may_start) : lasting;
}

Workability workability_of(const AccessHistory& history, const WindowNeed& need) {
  expects(history.months.empty() ? history.steps == 0
                                 : history.months.back().steps.end == history.steps,
          "the months of a history are those of its steps");
  const std::vector<MonthCounts> months = counts_of(history, need);
  std::vector<const MonthCounts*> all;
  std::map<int, std::vector<const MonthCounts*>> of_month;
  std::map<int, std::vector<const MonthCounts*>> of_year;
  for (std::size_t m = 0; m < months.size(); ++m) {
    all.push_back(&months[m]);
    of_month[history.months[m].month].push_back(&months[m]);
    of_year[history.months[m].year].push_back(&months[m]);
  }
  WaitingTimes times;
  Workability result;
  result.overall = together(all, history.step_h, times);
  for (const auto& [month, parts] : of_month)
    result.by_month.push_back({month, together(parts, history.step_h, times)});
  for (const auto& [year, parts] : of_year)
    result.by_year.push_back({year, together(parts, history.step_h, times)});
  return result;
}

}  // namespace slackwater::twin
