#pragma once
#include "calibration/day/forecast_column.h"
#include "calibration/day/given/forecast_plan.h"
#include "fields/record/site_data.h"

/// The plan of a forecast, moved to a past day that is rehearsed for it.
namespace slackwater::calibration {

/// Days of lead that are rehearsed, at most.
inline constexpr int most_rehearsed_leads = 3;

/// The plan moved to another day, issued as late after it, and knowing no more; editions of values
/// are those of now.
[[nodiscard]] ForecastPlan moved_to(const ForecastPlan& plan, UtcDay day);
/// Days of lead that are rehearsed.
[[nodiscard]] int lead_days_of(const ForecastPlan& plan);
/// The plan of a past day as it would have been run then, without members: they are not looked at,
/// and sigma is the same.
[[nodiscard]] ForecastPlan past_plan(const ForecastPlan& plan, UtcDay day);
/// The plan with runs of the wind to be simulated for past days, where one is known for the days to
/// come. What was analysed later stands for them under hindsight, and nothing where wind persists.
[[nodiscard]] ForecastPlan with_past_runs(const ForecastPlan& plan, const SiteData& data,
                                          const ColumnParts& parts);

}  // namespace slackwater::calibration
