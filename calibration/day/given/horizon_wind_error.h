#pragma once
#include "calibration/day/given/forecast_plan.h"
#include "calibration/day/given/horizon.h"
#include "calibration/propagate/wind_error.h"
#include "fields/record/record.h"

namespace slackwater::calibration {

/// How wrong the wind after D may be: by where most of it comes from, with what gaps and heights
/// add.
[[nodiscard]] WindErrorGrowth horizon_wind_error(const VectorRecord& record,
                                                 const HorizonWind& wind, const ForecastPlan& plan);

}  // namespace slackwater::calibration
