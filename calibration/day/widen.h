#pragma once
#include <optional>

#include "calibration/day/daily_forecast.h"
#include "calibration/day/day_choice.h"

namespace slackwater::calibration {

/// Means over hours are no instants: their bands are widened by the tide that they leave out. Of
/// several columns the widest speaks; one whose tide nobody knows speaks for all. Nothing where the
/// currents hold their tide.
[[nodiscard]] std::optional<AveragedCurrents> widen_means(const SiteData& data,
                                                          const ForecastOptions& options,
                                                          const DayChoice& choice,
                                                          DailyForecast& result);

/// Where another product stands in for the leading one, the bands are widened by what the two are
/// known to differ; not those of means over hours, which `widen_means` has widened by the tide that
/// makes most of it.
void widen_stand_in(const SiteData& data, const ForecastOptions& options, const DayChoice& choice,
                    DailyForecast& result);

}  // namespace slackwater::calibration
