#pragma once
#include <string>
#include <vector>

#include "calibration/verify/current_skill.h"
#include "calibration/verify/skill_entry.h"
#include "fields/record/site_data.h"
#include "fields/service/snapshot.h"

namespace slackwater::calibration {

/// Scores one forecast, currents, wind and waves, against the truth that the data hold now, with
/// every baseline beside it. Pure; the same for any number of threads.
[[nodiscard]] ForecastSkill score_forecast(const SiteData& data, const Snapshot& snapshot,
                                           const CurrentSource& currents,
                                           const VerifyOptions& options);

/// Scores of many forecasts, and what a page draws of them where the options ask for it.
struct Verification {
  std::vector<SkillEntry> entries;
  std::vector<ForecastTrace> traces;  ///< in the order of the forecasts
  std::vector<std::string> unscored;  ///< "forecast 12 of day 2024-01-03: why"
};

}  // namespace slackwater::calibration
