#pragma once
#include <optional>
#include <string>
#include <vector>

#include "calibration/day/daily_forecast.h"
#include "calibration/day/day_choice.h"

namespace slackwater::calibration {

/// What was late, missing, damaged or failed, a clause each; with any of them the forecast is
/// degraded.
/// @param averaged  what is known of currents that are means over hours
[[nodiscard]] std::vector<std::string> troubles_of(const SiteData& data, const DayChoice& choice,
                                                   const std::optional<AveragedCurrents>& averaged,
                                                   const DailyForecast& made);

/// The sentence that a coordinator reads first.
[[nodiscard]] std::string headline_of(const ForecastPlan& plan,
                                      const std::vector<std::string>& troubles,
                                      const Snapshot& made);

/// A forecast without one value must not stand in the place of the one before it: an Error that
/// says what was the trouble, of the kind of the part that failed, else not_found.
void expect_any_value(const DailyForecast& made, const std::vector<std::string>& troubles);

}  // namespace slackwater::calibration
