#pragma once
#include "api/ask/morning/morning.h"
#include "api/show/report/forecast_page.h"
#include "calibration/verify/skill_entry.h"

namespace slackwater::api {

/// The page of a morning: the answer for each task, the plan and where it is signed first, then the
/// forecast with its bands (`forecast_page`), the risks of what was flown, yesterday's forecast
/// beside what came, and where everything is from.
/// @param forecast  of the windows' forecast; its `skill` is of issued forecasts whose truth is in
[[nodiscard]] ReportInput morning_page(const Morning& morning, const ForecastPage& forecast);

}  // namespace slackwater::api
