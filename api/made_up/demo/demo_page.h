#pragma once
#include "api/ask/morning/morning.h"
#include "api/made_up/demo/demo_run.h"
#include "api/show/report/report.h"

namespace slackwater::api {

/// The demonstration's page: the morning report of its newest forecast with the truth drawn beside
/// it, and how each day did against the truth.
/// @param morning  of the windows of that forecast
[[nodiscard]] ReportInput demo_page(const DemoResult& result, const Morning& morning,
                                    const std::string& generated);

}  // namespace slackwater::api
