#include "api/ask/windows/unforecast.h"

#include <algorithm>
#include <vector>

namespace slackwater::api {
namespace {

using Sources = std::vector<DataStatus>;

bool rests_on(const TaskWindows& task, std::initializer_list<twin::LimitVariable> variables) {
  return std::any_of(task.limits.begin(), task.limits.end(), [&](const TaskLimit& limit) {
    return limit.limit &&
           std::find(variables.begin(), variables.end(), limit.limit->variable) != variables.end();
  });
}

/// Of the first column that has any; null where none has.
const Sources* sources_of(const Snapshot& forecast, Sources ForecastColumn::*which) {
  for (const ForecastColumn& column : forecast.columns)
    if (!(column.*which).empty()) return &(column.*which);
  return nullptr;
}

}  // namespace

std::string unforecast(const Snapshot& forecast, const TaskWindows& task, UtcTime from,
                       UtcTime to) {
  using twin::LimitVariable;
  const bool by_waves =
      rests_on(task, {LimitVariable::significant_wave_height, LimitVariable::wave_peak_period});
  const bool by_wind = rests_on(
      task, {LimitVariable::wind_speed, LimitVariable::wind_speed_10m, LimitVariable::gust_speed});
  const Sources* const waves = sources_of(forecast, &ForecastColumn::sea_source);
  const Sources* const wind = sources_of(forecast, &ForecastColumn::wind_source);
  std::string found;
  for (std::size_t t = 0; t < forecast.time.size(); ++t) {
    const bool begins_after = t > 0 && forecast.time[t - 1] >= to;
    const bool ends_before = t + 1 < forecast.time.size() && forecast.time[t + 1] <= from;
    if (begins_after || ends_before) continue;
    const bool is_wind_held = wind != nullptr && (*wind)[t] == DataStatus::persisted;
    if (by_waves && waves != nullptr && (*waves)[t] == DataStatus::persisted)
      return "the waves are the last known sea, kept";
    if (by_waves && waves != nullptr && (*waves)[t] == DataStatus::modelled && is_wind_held)
      found = "the waves are computed from a wind that is the last known one, fading";
    if (by_wind && is_wind_held && found.empty()) found = "the wind is the last known one, fading";
  }
  return found;
}

double most_worth_unforecast(const twin::VerdictRule& rule) noexcept {
  constexpr double below = 0.01;
  return std::max(0.0, rule.go - below);
}

}  // namespace slackwater::api
