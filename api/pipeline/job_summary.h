#pragma once
#include <nlohmann/json_fwd.hpp>

#include "api/pipeline/daily_job.h"

namespace slackwater::api {

/// The job as JSON, stored beside the forecast and told with it: effective configuration,
/// calibration of each column (parameters, sigma, misfit by depth, termination), notes, inputs.
[[nodiscard]] nlohmann::json job_summary(const DailyJob& job);

}  // namespace slackwater::api
