#pragma once
#include "calibration/day/column/column_calibration.h"
#include "calibration/day/given/forecast_plan.h"
#include "fields/record/site_data.h"

namespace slackwater::calibration {

/// What a column's products say of the mixed layer, as known at the end of D.
struct LayerRecord {
  Chosen<double> values;
  bool is_stated = false;  ///< `mlotst`; else temperatures
};

/// `mlotst` where it is stored, else temperatures.
[[nodiscard]] LayerRecord layer_record(const ColumnData& column, const ForecastPlan& plan);

/// The mixed layer on D and on the days of the chain before it: as stated, else from the
/// temperature profile.
[[nodiscard]] LayerOfDays layer_of_days(const LayerRecord& record, UtcDay day);

}  // namespace slackwater::calibration
