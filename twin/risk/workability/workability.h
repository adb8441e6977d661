#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "twin/risk/workability/calendar.h"
#include "twin/risk/workability/step_range.h"
#include "twin/risk/workability/waiting_time.h"

namespace slackwater::twin {

/// How often and how long a place can be worked at, over the steps of a series or over those of
/// some months of it. A window and a storm belong whole to the month in which they begin; a wait to
/// the month of the step from which one waits.
struct WindowStatistics {
  double step_h = 1;
  std::size_t steps = 0;
  std::size_t missing_steps = 0;     ///< nobody knows a value that a limit asks for
  std::size_t accessible_steps = 0;  ///< all limits hold
  std::size_t workable_starts = 0;   ///< the task can start, at an hour at which it may
  std::size_t lasting_steps = 0;     ///< access lasts for the task from here, whatever the hour
  std::size_t windows = 0;           ///< maximal runs of accessible steps
  std::size_t workable_windows = 0;  ///< those that hold a workable start
  std::size_t window_steps = 0;      ///< of all windows together
  std::size_t longest_window_steps = 0;
  std::size_t storms = 0;  ///< maximal runs of steps that are not accessible
  std::size_t storm_steps = 0;
  std::size_t longest_storm_steps = 0;
  WaitingTime waiting;

  /// Accessible steps / steps. NaN of no step, as all ratios here.
  [[nodiscard]] double accessibility() const noexcept;
  /// Workable starts / steps: the probability that the task can start.
  [[nodiscard]] double workability() const noexcept;
  /// That access lasts for the task, given that there is access.
  [[nodiscard]] double persistence() const noexcept;
  [[nodiscard]] double mean_window_h() const noexcept;
  [[nodiscard]] double mean_storm_h() const noexcept;
};

struct MonthStatistics {
  int month = 0;  ///< 1 to 12, of all years together
  WindowStatistics statistics;
};
struct YearStatistics {
  int year = 0;
  WindowStatistics statistics;
};
struct Workability {
  WindowStatistics overall;
  std::vector<MonthStatistics> by_month;  ///< those that the series has, ascending
  std::vector<YearStatistics> by_year;
};

/// A history as the limits leave it.
struct AccessHistory {
  std::size_t steps = 0;
  double step_h = 1;
  StepRanges windows;              ///< maximal runs of accessible steps
  StepRanges missing;              ///< steps without a value that a limit asks for; in no window
  std::vector<MonthSteps> months;  ///< of all steps
};

/// What a task needs of a window.
struct WindowNeed {
  std::size_t steps = 1;                  ///< duration and contingency (`steps_needed`)
  std::optional<StepRanges> may_start{};  ///< steps at which it may start; absent: at all
};

/// The workable starts of a history for a task.
[[nodiscard]] StepRanges starts_for(const AccessHistory& history, const WindowNeed& need);

/// All of it in time proportional to the number of windows and months. Thread-safe.
/// Source of the definitions: twin/docs/operations.md, section 3; of the percentiles:
/// `percentile_place`.
[[nodiscard]] Workability workability_of(const AccessHistory& history, const WindowNeed& need);

}  // namespace slackwater::twin
