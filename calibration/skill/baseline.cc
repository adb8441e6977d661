#include "calibration/skill/baseline.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "calibration/skill/history.h"
#include "calibration/skill/reference_slab.h"
#include "calibration/skill/tide_baseline.h"
#include "fields/base/check.h"
#include "fields/base/numbers/statistics.h"

namespace slackwater::calibration {
namespace {

constexpr Duration same_hour_period = std::chrono::hours(24);
constexpr Duration tide_phase_period = std::chrono::seconds(89424);  // 24.84 h, two periods of M2

/// Evaluates `at(level, cell)` (an optional value) everywhere.
template <typename At>
BaselineForecast everywhere(std::size_t levels, std::span<const TimeCell> truth_time, At at) {
  BaselineForecast forecast = nothing_yet(truth_time.size(), levels);
  for (std::size_t k = 0; k < levels; ++k) {
    for (std::size_t t = 0; t < truth_time.size(); ++t) {
      const std::optional<Horizontal> value = at(k, truth_time[t]);
      if (!value) continue;
      forecast.value[t * levels + k] = *value;
      forecast.status[t * levels + k] = SampleStatus::ok;
    }
  }
  return forecast;
}

BaselineOutcome constant_of_day(const BaselineInput& input, std::span<const TimeCell> truth_time,
                                bool mean) {
  std::vector<std::optional<Horizontal>> constant;
  for (std::size_t k = 0; k < input.current.levels(); ++k) {
    const LevelSeries day = within_day(level_series(input.current, k), input.day);
    constant.emplace_back();
    if (!day.empty()) constant.back() = mean ? mean_of(day.value) : day.value.back();
  }
  return outcome_of(everywhere(constant.size(), truth_time,
                               [&](std::size_t k, const TimeCell&) { return constant[k]; }),
                    "no current on " + format_day(input.day));
}

Duration usual_step(const LevelSeries& series) {
  std::vector<Duration> step;
  for (std::size_t i = 1; i < series.size(); ++i)
    step.push_back(series.time[i].centre() - series.time[i - 1].centre());
  if (step.empty()) return Duration(0);
  return upper_median(std::move(step));
}

/// Value at this time, linear between neighbours at most two usual steps apart.
std::optional<Horizontal> value_near(const LevelSeries& series, UtcTime time, Duration step) {
  const auto after =
      std::lower_bound(series.time.begin(), series.time.end(), time,
                       [](const TimeCell& cell, UtcTime t) { return cell.centre() < t; });
  const auto i = static_cast<std::size_t>(after - series.time.begin());
  if (i < series.size() && series.time[i].centre() == time) return series.value[i];
  if (i == 0 || i == series.size()) return std::nullopt;
  const Duration apart = series.time[i].centre() - series.time[i - 1].centre();
  if (apart > 2 * step) return std::nullopt;
  const double share = seconds_between(series.time[i - 1].centre(), time) /
                       std::chrono::duration<double>(apart).count();
  return (1.0 - share) * series.value[i - 1] + share * series.value[i];
}

/// The history from a time on, a whole number of periods earlier: the fewest for which it lies in
/// the history.
BaselineOutcome repeated(const BaselineInput& input, std::span<const TimeCell> truth_time,
                         Duration period, UtcTime from, const std::string& reason) {
  const UtcTime end = end_of_day(input.day);
  std::vector<LevelSeries> series;
  std::vector<Duration> step;
  for (std::size_t k = 0; k < input.current.levels(); ++k) {
    series.push_back(level_series(input.current, k));
    step.push_back(usual_step(series.back()));
  }
  const auto earlier = [&](std::size_t k, const TimeCell& cell) -> std::optional<Horizontal> {
    if (series[k].empty()) return std::nullopt;
    // Means end half a step before the end of D: the last centre is the last place to read.
    const UtcTime last = std::min(end, series[k].time.back().centre());
    Duration::rep times = 1;
    if (cell.centre() - period > last)
      times = (cell.centre() - last + period - Duration(1)) / period;
    const UtcTime then = cell.centre() - times * period;
    if (then < from) return std::nullopt;
    return value_near(series[k], then, step[k]);
  };
  return outcome_of(everywhere(series.size(), truth_time, earlier), reason);
}

BaselineOutcome harmonic(const BaselineInput& input, std::span<const TimeCell> truth_time) {
  std::optional<ColumnTide> own;
  if (input.tide == nullptr) own.emplace(input.current, input.day, input.tide_since);
  const ColumnTide& tide = own ? *own : *input.tide;
  const std::size_t levels = input.current.levels();
  BaselineForecast forecast = nothing_yet(truth_time.size(), levels);
  forecast.value = tide.oscillation(truth_time);
  for (std::size_t t = 0; t < truth_time.size(); ++t) {
    for (std::size_t k = 0; k < levels; ++k) {
      if (!tide.has(k)) continue;
      forecast.value[t * levels + k] += tide.mean(k);
      forecast.status[t * levels + k] = SampleStatus::ok;
    }
  }
  return outcome_of(std::move(forecast),
                    "the record up to " + format_day(input.day) +
                        (input.tide_since == UtcTime::min() ? "" : ", as far as it holds tide,") +
                        " is shorter than 15 days; tide-harmonic needs 15 days");
}

/// Mean of the truth over each day of lead.
BaselineOutcome oracle(const BaselineInput& input, std::span<const TimeCell> truth_time,
                       const VectorColumn* truth) {
  if (truth == nullptr) return {std::nullopt, "oracle-mean needs the truth itself"};
  expects(truth->levels() == input.current.levels(), "truth and history have the same levels");
  const UtcTime end = end_of_day(input.day);
  // Lead (0, 24] h is day 0: an instant at 24:00 closes the day before.
  const auto day_of_lead = [&](const TimeCell& cell) {
    return static_cast<int>(std::ceil(hours_between(end, cell.centre()) / 24.0 - 1e-9)) - 1;
  };
  std::vector<std::map<int, std::vector<Horizontal>>> days(truth->levels());
  for (std::size_t k = 0; k < truth->levels(); ++k)
    for (std::size_t t = 0; t < truth->times(); ++t)
      if (truth->has(t, k))
        days[k][day_of_lead(truth->time[t])].push_back(truth->value[truth->offset(t, k)]);
  const auto mean = [&](std::size_t k, const TimeCell& cell) -> std::optional<Horizontal> {
    const auto found = days[k].find(day_of_lead(cell));
    if (found == days[k].end()) return std::nullopt;
    return mean_of(found->second);
  };
  return outcome_of(everywhere(days.size(), truth_time, mean),
                    "no truth after " + format_day(input.day));
}

}  // namespace

BaselineOutcome make_baseline(Method baseline, const BaselineInput& input,
                              std::span<const TimeCell> truth_time, const VectorColumn* truth) {
  expects(input.current.time.empty() || input.current.time.back().end <= end_of_day(input.day),
          "a baseline's history ends with day D");
  if (input.tide_since == UtcTime::max() &&
      (baseline == Method::tide_harmonic || baseline == Method::tide_phase)) {
    return {std::nullopt, "the currents are detided: they hold no tide that " +
                              std::string(name_of(baseline)) + " could carry on"};
  }
  switch (baseline) {
    case Method::persistence:
      return constant_of_day(input, truth_time, false);
    case Method::day_mean:
      return constant_of_day(input, truth_time, true);
    case Method::same_hour:
      return repeated(input, truth_time, same_hour_period, UtcTime::min(),
                      "no history 24 h before any of the forecast times");
    case Method::tide_phase:
      return repeated(input, truth_time, tide_phase_period, input.tide_since,
                      "no history 24.84 h before any of the forecast times");
    case Method::tide_harmonic:
      return harmonic(input, truth_time);
    case Method::oracle_mean:
      return oracle(input, truth_time, truth);
    case Method::reference_slab:
      return reference_slab_forecast(input, truth_time);
    case Method::forecast:
    case Method::merged:
    case Method::provider:
      break;
  }
  expects(false, "a baseline without a recipe");
  return {};
}

}  // namespace slackwater::calibration
