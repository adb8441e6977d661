#pragma once
#include <string>
#include <vector>

#include "calibration/verify/current_skill.h"
#include "calibration/verify/skill_entry.h"
#include "data/store/store.h"
#include "fields/site/site.h"

namespace slackwater::api {

/// Forecasts of the past, to be held against what came.
struct ForecastsToScore {
  std::vector<store::ForecastRow> rows;
  std::vector<std::string> damaged;  ///< what was passed over, in words
};

/// Of each day and wind policy the one as issued (api/issued/as_issued.h) whose file is whole, in
/// order of day.
[[nodiscard]] ForecastsToScore forecasts_to_score(store::Store& store, const Site& site,
                                                  const calibration::VerifyOptions& options);

/// Which currents a forecast was made from, by the summary filed beside it.
[[nodiscard]] calibration::CurrentSource currents_of_summary(const std::string& summary_json);

}  // namespace slackwater::api
