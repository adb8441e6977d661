#pragma once
#include "calibration/day/column_calibration.h"
#include "calibration/day/forecast_plan.h"
#include "fields/record/site_data.h"

namespace slackwater::calibration {

/// The record of the mixed layer as known at the end of D: `mlotst` where it is stored, else
/// temperatures.
[[nodiscard]] Chosen<double> layer_record(const ColumnData& column, const ForecastPlan& plan);

/// What the stored products say of the mixed layer on D and on the days of the chain before it, as
/// known at the end of D: `mlotst` where it is stored, else from the temperature profile.
[[nodiscard]] LayerOfDays layer_of_days(const ColumnData& column, const ForecastPlan& plan);

}  // namespace slackwater::calibration
