#pragma once
#include <string>

#include "api/show/report/report.h"

namespace slackwater::api {

/// What the plots of the page draw, as JSON that is safe inside a <script> element: numbers rounded
/// to 0.1 mm/s, null where there is no value, `<` written as \u003c. Times are milliseconds since
/// 1970, UTC.
[[nodiscard]] std::string plot_data_json(const ReportInput& input);

}  // namespace slackwater::api
