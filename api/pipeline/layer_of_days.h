#pragma once
#include "api/pipeline/column_calibration.h"
#include "api/pipeline/forecast_column.h"

namespace slackwater::api {

/// What the stored products say of the mixed layer on D and on the days of the chain before it, as known
/// at the end of D: `mlotst` where it is stored, else from the temperature profile.
[[nodiscard]] LayerOfDays layer_of_days(const ColumnData& column, const ForecastPlan& plan);

}  // namespace slackwater::api
