#pragma once
#include "api/demo/demo_run.h"
#include "api/report/report.h"

namespace slackwater::api {

/// The demonstration's page: the newest forecast over time and depth with the truth beside it, the
/// hodograph, the skill by lead and method, wind and waves.
[[nodiscard]] ReportInput demo_page(const DemoResult& result, const std::string& generated);

}  // namespace slackwater::api
