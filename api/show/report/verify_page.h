#pragma once
#include <string>

#include "api/show/report/skill_page.h"
#include "calibration/verify/score_forecast.h"
#include "fields/site/site.h"

namespace slackwater::api {

/// The page of a verification made with traces: skill by lead, reliability, hodographs, misfit, and
/// the tables behind them. Its headline says whether the forecast beats its best baseline in the
/// first lead bin of the widest band.
/// @param generated  when and by what the page was made
[[nodiscard]] SkillPage verify_page(const Site& site, const calibration::Verification& result,
                                    const std::string& generated);

}  // namespace slackwater::api
