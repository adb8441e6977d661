#pragma once
#include <string>

#include "calibration/day/given/forecast_plan.h"
#include "fields/record/choose.h"
#include "fields/record/site_data.h"

namespace slackwater::calibration {

/// The truth of a column after D, at its own levels and times: the in-situ series nearest to the
/// site (within 5 km, or farther where no product is there) if it has values then at depths that
/// the dataset spans; else the dataset itself, analysed or observed.
[[nodiscard]] Chosen<Horizontal> truth_of(const ColumnData& column, const std::string& dataset,
                                          UtcTime end_of_day, UtcTime until);

/// What was known up to the end of D on the levels of a truth: the record that baselines start
/// from. The truth's own dataset, unfused; where that has nothing on D, the plan's record brought
/// to the truth's depths.
[[nodiscard]] Chosen<Horizontal> known_beside(const Chosen<Horizontal>& truth,
                                              const ColumnData& column, const ForecastPlan& plan);

}  // namespace slackwater::calibration
