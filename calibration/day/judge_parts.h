#pragma once
#include <string>
#include <vector>

#include "calibration/day/daily_forecast.h"

namespace slackwater::calibration {

/// Adds to the troubles of a headline which parts had to be left out, each once.
void judge_parts(const DailyForecast& result, std::vector<std::string>& troubles);

/// A forecast without one value must not stand in the place of the one before it: an Error that
/// says what was the trouble, of the kind of the part that failed, else not_found.
void expect_any_value(const DailyForecast& result, const std::vector<std::string>& troubles);

}  // namespace slackwater::calibration
