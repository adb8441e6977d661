#pragma once
#include <string>

#include "calibration/day/daily_forecast.h"

namespace slackwater::api {

/// The job as JSON, stored beside the forecast: effective configuration, calibration of each column
/// (parameters, sigma, misfit by depth, termination), notes, inputs.
[[nodiscard]] std::string job_summary(const SiteData& data,
                                      const calibration::ForecastOptions& options,
                                      const calibration::DailyForecast& forecast);

/// What a number served from the forecast can name: inputs by sha256 and product, code version,
/// water depth.
[[nodiscard]] std::string job_provenance(const SiteData& data,
                                         const calibration::ForecastOptions& options,
                                         const calibration::DailyForecast& forecast);

}  // namespace slackwater::api
