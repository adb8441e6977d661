#include "calibration/skill/history.h"

#include <algorithm>
#include <numeric>

namespace slackwater::calibration {

UtcTime end_of_day(UtcDay day) noexcept { return UtcTime(day) + std::chrono::days(1); }

LevelSeries level_series(const VectorColumn& column, std::size_t level) {
  LevelSeries series;
  for (std::size_t t = 0; t < column.times(); ++t) {
    if (!column.has(t, level)) continue;
    series.time.push_back(column.time[t]);
    series.value.push_back(column.value[column.offset(t, level)]);
  }
  return series;
}

LevelSeries within_day(const LevelSeries& series, UtcDay day) {
  LevelSeries part;
  for (std::size_t i = 0; i < series.size(); ++i) {
    if (!belongs_to_day(series.time[i], day)) continue;
    part.time.push_back(series.time[i]);
    part.value.push_back(series.value[i]);
  }
  return part;
}

Horizontal mean_of(std::span<const Horizontal> values) noexcept {
  return std::accumulate(values.begin(), values.end(), Horizontal{}) /
         static_cast<double>(values.size());
}

BaselineForecast nothing_yet(std::size_t truth_times, std::size_t levels) {
  BaselineForecast forecast;
  forecast.value.resize(truth_times * levels);
  forecast.status.resize(truth_times * levels, SampleStatus::missing);
  return forecast;
}

BaselineOutcome outcome_of(BaselineForecast forecast, std::string reason_if_empty) {
  if (std::none_of(forecast.status.begin(), forecast.status.end(), has_value))
    return {std::nullopt, std::move(reason_if_empty)};
  return {std::move(forecast), {}};
}

}  // namespace slackwater::calibration
