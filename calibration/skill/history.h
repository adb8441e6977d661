#pragma once
#include <span>
#include <vector>

#include "calibration/skill/baseline.h"
#include "fields/base/time.h"
#include "fields/interpolate/column.h"

namespace slackwater::calibration {

/// The end of day D, from which leads count.
[[nodiscard]] UtcTime end_of_day(UtcDay day) noexcept;

/// One level of a column as a series of its values: only cells that have one.
struct LevelSeries {
  std::vector<TimeCell> time;
  std::vector<Horizontal> value;
  [[nodiscard]] bool empty() const noexcept { return time.empty(); }
  [[nodiscard]] std::size_t size() const noexcept { return time.size(); }
};

[[nodiscard]] LevelSeries level_series(const VectorColumn& column, std::size_t level);
/// The part that belongs to the closed day.
[[nodiscard]] LevelSeries within_day(const LevelSeries& series, UtcDay day);

[[nodiscard]] Horizontal mean_of(std::span<const Horizontal> values) noexcept;

/// An empty forecast: every value missing.
[[nodiscard]] BaselineForecast nothing_yet(std::size_t truth_times, std::size_t levels);
/// The forecast, or the reason where no level has a value.
[[nodiscard]] BaselineOutcome outcome_of(BaselineForecast forecast, std::string reason_if_empty);

}  // namespace slackwater::calibration
