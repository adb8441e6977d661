#pragma once
#include <string>

#include "api/pipeline/daily_job.h"

namespace slackwater::api {

/// The job as JSON, stored beside the forecast: effective configuration, calibration of each column
/// (parameters, sigma, misfit by depth, termination), notes, inputs.
[[nodiscard]] std::string job_summary(const SiteData& data, const ForecastPlan& plan,
                                      const JobOptions& options, const DailyForecast& forecast);

/// What a number served from the forecast can name: inputs by sha256 and product, code version,
/// water depth.
[[nodiscard]] std::string job_provenance(const SiteData& data, const JobOptions& options,
                                         const DailyForecast& forecast);

}  // namespace slackwater::api
