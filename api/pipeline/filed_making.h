#pragma once
#include <optional>
#include <string>

#include "calibration/day/forecast_making.h"

namespace slackwater::api {

/// How a stored forecast was made, from the summary that is filed beside it (job_summary.h);
/// nothing where that does not say, as of a forecast of another program.
[[nodiscard]] std::optional<calibration::ForecastMaking> filed_making(
    const std::string& summary_json);

}  // namespace slackwater::api
