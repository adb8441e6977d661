#include "api/pipeline/skill_pairs.h"

#include <algorithm>
#include <cmath>

#include "calibration/skill/baseline.h"
#include "fields/interpolate/temporal.h"

namespace slackwater::api {
namespace {

using std::chrono::hours;

/// Neighbouring snapshot levels of a truth level; nothing outside them by more than a hand's
/// breadth.
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

std::size_t six_hour_block(const TimeCell& cell) {
  return static_cast<std::size_t>(
      std::max<std::int64_t>(0, cell.centre().time_since_epoch() / hours(6)));
}

void add(Pairs& pairs, Horizontal forecast, Horizontal truth, double depth_m, const TimeCell& cell,
         UtcTime end_of_day) {
  pairs.forecast.push_back(forecast);
  pairs.truth.push_back(truth);
  pairs.depth_m.push_back(depth_m);
  pairs.lead_h.push_back(hours_between(end_of_day, cell.centre()));
  pairs.block.push_back(six_hour_block(cell));
}

/// The forecast as issued at the truth's own cells and levels.
void add_forecast(Pairs& pairs, const Snapshot& snapshot, std::size_t index,
                  const VectorColumn& truth, UtcTime end_of_day) {
  const ForecastColumn& column = snapshot.columns[index];
  const std::size_t levels = snapshot.depth_m.size();
  if (column.current_m_s.empty()) return;
  std::vector<Horizontal> sigma(column.current_sigma_m_s.begin(), column.current_sigma_m_s.end());
  for (std::size_t k = 0; k < truth.levels(); ++k) {
    const double depth = truth.levels_m[k];
    const auto place = level_place(snapshot.depth_m, depth);
    if (!place || !has_value(column.current_status[place->low]) ||
        !has_value(column.current_status[place->high])) {
      continue;
    }
    for (std::size_t t = 0; t < truth.times(); ++t) {
      if (!truth.has(t, k)) continue;
      const auto blend = [&](const std::vector<Horizontal>& values) -> std::optional<Horizontal> {
        const auto low = mean_over(snapshot.time, values, levels, place->low, truth.time[t]);
        const auto high = mean_over(snapshot.time, values, levels, place->high, truth.time[t]);
        if (!low || !high) return std::nullopt;
        return (1 - place->share) * *low + place->share * *high;
      };
      const auto value = blend(column.current_m_s);
      if (!value) continue;
      add(pairs, *value, truth.value[truth.offset(t, k)], depth, truth.time[t], end_of_day);
      pairs.sigma_m_s.push_back(blend(sigma)->real());
    }
  }
}

void add_baseline(Pairs& pairs, const calibration::BaselineForecast& made,
                  const VectorColumn& truth, UtcTime end_of_day) {
  for (std::size_t k = 0; k < truth.levels(); ++k) {
    for (std::size_t t = 0; t < truth.times(); ++t) {
      const std::size_t o = truth.offset(t, k);
      if (!truth.has(t, k) || !made.has(o)) continue;
      add(pairs, made.value[o], truth.value[o], truth.levels_m[k], truth.time[t], end_of_day);
    }
  }
}

/// The provider's own forecast issued by the end of D, at the truth's cells.
void add_provider(Pairs& pairs, const ColumnData& column, const std::string& dataset,
                  const VectorColumn& truth, UtcTime end_of_day) {
  Choice choice;
  choice.dataset = dataset;
  choice.only_forecasts = true;
  const Chosen<Horizontal> provider = choose(column.current, {end_of_day, end_of_day}, choice);
  if (provider.empty() || provider.column.levels() != truth.levels()) return;
  for (std::size_t p = 0; p < provider.column.times(); ++p) {
    for (std::size_t t = 0; t < truth.times(); ++t) {
      if (!(provider.column.time[p] == truth.time[t])) continue;
      for (std::size_t k = 0; k < truth.levels(); ++k) {
        if (!truth.has(t, k) || !provider.column.has(p, k)) continue;
        add(pairs, provider.column.value[provider.column.offset(p, k)],
            truth.value[truth.offset(t, k)], truth.levels_m[k], truth.time[t], end_of_day);
      }
    }
  }
}

}  // namespace

std::map<std::string, Pairs> current_pairs(const ColumnData& column, const ForecastPlan& plan,
                                           const Snapshot& snapshot, std::size_t column_index,
                                           const Chosen<Horizontal>& truth) {
  std::map<std::string, Pairs> pairs;
  const UtcTime end = plan.end_of_day();
  add_forecast(pairs["forecast"], snapshot, column_index, truth.column, end);
  const Chosen<Horizontal> known = known_beside(truth, column, plan);
  if (!known.empty()) {
    // Held wind is that of the end of D, on the line between the stamps around it.
    const WindPolicy policy = plan.wind == WindPolicy::persist ? WindPolicy::best : plan.wind;
    const HorizonWind wind = horizon_wind(column.nearest_wind, policy, end, {});
    calibration::BaselineInput input{plan.day, known.column, wind.series ? &*wind.series : nullptr,
                                     column.point.latitude, plan.wind == WindPolicy::persist};
    for (const calibration::Baseline baseline : calibration::all_baselines) {
      const auto made =
          calibration::make_baseline(baseline, input, truth.column.time, &truth.column);
      if (made.forecast) {
        add_baseline(pairs[std::string(name_of(baseline))], *made.forecast, truth.column, end);
      }
    }
  }
  add_provider(pairs["provider"], column, plan.dataset, truth.column, end);
  std::erase_if(pairs, [](const auto& entry) { return entry.second.truth.empty(); });
  return pairs;
}

}  // namespace slackwater::api
