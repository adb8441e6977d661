#pragma once
#include <vector>

#include "calibration/day/column/column_calibration.h"
#include "calibration/day/given/forecast_plan.h"
#include "calibration/provider/provider_runs.h"
#include "calibration/skill/baseline.h"
#include "fields/record/choose.h"
#include "fields/record/site_data.h"
#include "fields/service/snapshot.h"

namespace slackwater::calibration {

/// One method evaluated at the truth's own cells and levels.
struct MethodForecast {
  Method method = Method::forecast;
  BaselineForecast made;  ///< shape of the truth
  /// Standard deviation of each component, shape of the truth; empty for a method without spread.
  std::vector<double> sigma_m_s;
};

/// The provider's own forecast of a column as published by the issue time, with runs that ended so
/// long before D that their errors are learnt from.
[[nodiscard]] ProviderRuns known_provider(const ColumnData& column, const ForecastPlan& plan);

/// The forecast as issued, every baseline that the column's record allows and the provider's own
/// forecast; those without any value are left out. `known` is the record up to the end of D that
/// baselines start from, on the truth's levels. Each baseline is made once. Pure.
///
/// @param provider  `known_provider` of that column and plan
/// @param tide  of the record, for the candidates of a blend: `merged` is made as well, where a
///              provider forecasts, and no baseline sees a stamp of the wind after D where the wind
///              persists. Null: the methods to score, the provider's tide is fitted where it counts
[[nodiscard]] std::vector<MethodForecast> current_methods(
    const ColumnData& column, const ForecastPlan& plan, const Snapshot& snapshot,
    std::size_t column_index, const Chosen<Horizontal>& truth, const Chosen<Horizontal>& known,
    const ProviderRuns& provider, const FittedTide* tide = nullptr);

}  // namespace slackwater::calibration
