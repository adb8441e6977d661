#pragma once
#include <span>
#include <string>
#include <vector>

#include "fields/base/step_clock.h"
#include "fields/record/history_series.h"

namespace slackwater {

/// Series of one place on one clock.
struct RegularHistory {
  StepClock clock;
  /// One for each series, a value for each step; NaN where nobody says.
  std::vector<std::vector<double>> values;
  std::vector<Duration> own_step;  ///< of each series: how long one of its values holds
  std::vector<std::string> notes;  ///< what a reader should know of how they were laid
};

/// Lays series on the regular steps from the first time of any to the end of the last.
///
/// A series' own step is the shortest between its times, and each of its values holds over
/// [t, t + own step): so three-hourly waves stand beside hourly wind without being interpolated,
/// and what a series leaves out is missing. The steps of the clock divide the steps of all. Times
/// may stray from the regular ones by a twentieth of a step, as those of axes in days and single
/// precision do.
///
/// @throws Error(invalid_input) for a series of fewer than two times, times that are not regular
///         (which, and where), series whose times share no step, and more than `most_steps`
[[nodiscard]] RegularHistory on_regular_steps(std::span<const HistorySeries> series);

/// A thousand years of hours and more.
inline constexpr std::size_t most_steps = 20'000'000;

}  // namespace slackwater
