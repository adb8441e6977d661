#pragma once
#include "api/demo/demo_run.h"
#include "api/report/report.h"

namespace slackwater::api {

/// The demonstration's page: that of its newest forecast (api/report/forecast_page.h) with the
/// truth drawn beside it, and how each day did against the truth.
[[nodiscard]] ReportInput demo_page(const DemoResult& result, const std::string& generated);

}  // namespace slackwater::api
