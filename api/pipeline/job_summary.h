#pragma once
#include <string>

#include "calibration/day/daily_forecast.h"

namespace slackwater::api {

/// The job as JSON, stored beside the forecast: effective configuration, calibration of each column
/// (parameters, sigma, misfit by depth, termination), notes, inputs.
[[nodiscard]] std::string job_summary(const SiteData& data,
                                      const calibration::ForecastOptions& options,
                                      const calibration::DailyForecast& forecast);

}  // namespace slackwater::api
