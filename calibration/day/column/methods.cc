#include "calibration/day/column/methods.h"

#include <algorithm>
#include <cmath>

#include "calibration/day/column/merge.h"
#include "calibration/day/column/tide_of_record.h"
#include "calibration/day/given/horizon.h"
#include "calibration/provider/provider_forecast.h"
#include "calibration/skill/tide_baseline.h"
#include "fields/interpolate/temporal.h"

namespace slackwater::calibration {
namespace {

/// Neighbouring snapshot levels of a truth level; nothing above the first of them or below the last
/// by more than a millimetre.
struct LevelPlace {
  std::size_t low = 0;
  std::size_t high = 0;
  double share = 0;
};

std::optional<LevelPlace> level_place(const std::vector<double>& depth_m, double wanted_m) {
  constexpr double same_m = 1e-3;
  for (std::size_t k = 0; k < depth_m.size(); ++k) {
    if (std::abs(depth_m[k] - wanted_m) <= same_m) return LevelPlace{k, k, 0};
  }
  const auto above = std::upper_bound(depth_m.begin(), depth_m.end(), wanted_m);
  if (above == depth_m.begin() || above == depth_m.end()) return std::nullopt;
  const auto high = static_cast<std::size_t>(above - depth_m.begin());
  return LevelPlace{high - 1, high,
                    (wanted_m - depth_m[high - 1]) / (depth_m[high] - depth_m[high - 1])};
}

BaselineForecast nothing_at(const VectorColumn& truth) {
  BaselineForecast made;
  made.value.resize(truth.value.size());
  made.status.resize(truth.value.size(), SampleStatus::missing);
  return made;
}

bool has_any(const BaselineForecast& made) {
  return std::any_of(made.status.begin(), made.status.end(), has_value);
}

/// What was carried below the product's water is no forecast of it.
bool speaks(SampleStatus status) { return has_value(status) && status != SampleStatus::carried; }

/// The forecast as issued at the truth's own cells and levels: means over the truth's means, linear
/// between the forecast's depths.
MethodForecast as_issued(const Snapshot& snapshot, std::size_t index, const VectorColumn& truth) {
  MethodForecast method{Method::forecast, nothing_at(truth), {}};
  const ForecastColumn& column = snapshot.columns[index];
  const std::size_t levels = snapshot.depth_m.size();
  if (column.current_m_s.empty()) return method;
  method.sigma_m_s.resize(truth.value.size());
  const std::vector<Horizontal> sigma(column.current_sigma_m_s.begin(),
                                      column.current_sigma_m_s.end());
  for (std::size_t k = 0; k < truth.levels(); ++k) {
    const auto place = level_place(snapshot.depth_m, truth.levels_m[k]);
    if (!place || !speaks(column.current_status[place->low]) ||
        !speaks(column.current_status[place->high])) {
      continue;
    }
    for (std::size_t t = 0; t < truth.times(); ++t) {
      if (!truth.has(t, k)) continue;
      const auto blend = [&](const std::vector<Horizontal>& values) -> std::optional<Horizontal> {
        const auto low = mean_over(snapshot.time, values, levels, place->low, truth.time[t]);
        if (!low || place->share == 0) return low;
        const auto high = mean_over(snapshot.time, values, levels, place->high, truth.time[t]);
        if (!high) return std::nullopt;
        return (1 - place->share) * *low + place->share * *high;
      };
      const auto value = blend(column.current_m_s);
      if (!value) continue;
      const std::size_t o = truth.offset(t, k);
      method.made.value[o] = *value;
      method.made.status[o] = SampleStatus::ok;
      method.sigma_m_s[o] = blend(sigma)->real();
    }
  }
  return method;
}

/// The provider's own forecast at the truth's cells, and with `tide` the two merged.
void add_provider(const ProviderRuns& runs, Angle latitude, const ForecastPlan& plan,
                  const Chosen<Horizontal>& truth, const Chosen<Horizontal>& known,
                  const FittedTide* tide, std::vector<MethodForecast>& methods) {
  if (runs.empty() || runs.series.time.back().end <= plan.end_of_day()) return;
  const Chosen<Horizontal>& on_levels = known.empty() ? truth : known;
  if (tide == nullptr) {
    const FittedTide fitted =
        known.empty() ? FittedTide{} : tide_of_record(known, plan.day, latitude);
    methods.push_back(
        {Method::provider, provider_as_it_is(runs, on_levels, fitted, truth.column.time), {}});
    return;
  }
  ProviderForecast made =
      provider_forecast(runs, known, *tide, latitude, truth.column.time, plan.end_of_day());
  MethodForecast merged = merged_with(methods.front(), made, truth.column);
  methods.push_back({Method::provider, std::move(made.as_it_is), {}});
  methods.push_back(std::move(merged));
}

}  // namespace

ProviderRuns known_provider(const ColumnData& column, const ForecastPlan& plan) {
  return provider_runs(column.current, plan.dataset, plan.knowledge_of_runs(),
                       plan.end_of_day() - runs_looked_back);
}

std::vector<MethodForecast> current_methods(const ColumnData& column, const ForecastPlan& plan,
                                            const Snapshot& snapshot, std::size_t column_index,
                                            const Chosen<Horizontal>& truth,
                                            const Chosen<Horizontal>& known,
                                            const ProviderRuns& provider, const FittedTide* tide) {
  const UtcTime end = plan.end_of_day();
  std::vector<MethodForecast> methods;
  methods.push_back(as_issued(snapshot, column_index, truth.column));
  if (!known.empty()) {
    // Held wind is that of the end of D, on the line between the stamps around it; a candidate of a
    // blend knows no stamp after D.
    const bool holds_wind = plan.wind == WindPolicy::persist;
    const WindPolicy policy = holds_wind && tide == nullptr ? WindPolicy::best : plan.wind;
    const HorizonWind wind = horizon_wind(column.nearest_wind, policy, end, {}, plan.best);
    BaselineInput input{plan.day, known.column, wind.series ? &*wind.series : nullptr,
                        column.point.latitude, holds_wind};
    input.tide_since = tide_since(known, plan.day).value_or(UtcTime::max());
    for (const Method baseline : all_baselines) {
      auto outcome = make_baseline(baseline, input, truth.column.time, &truth.column);
      if (outcome.forecast) methods.push_back({baseline, std::move(*outcome.forecast), {}});
    }
  }
  add_provider(provider, column.point.latitude, plan, truth, known, tide, methods);
  std::erase_if(methods, [](const MethodForecast& method) { return !has_any(method.made); });
  return methods;
}

}  // namespace slackwater::calibration
