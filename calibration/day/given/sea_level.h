#pragma once
#include <string>
#include <vector>

#include "calibration/day/given/forecast_plan.h"
#include "fields/record/record.h"
#include "fields/service/sea_level.h"

namespace slackwater::calibration {

/// The level of a column over the plan's stamps.
struct LevelForecast {
  SeaLevel level;                      ///< empty where nothing can be said of it
  std::vector<const Origin*> origins;  ///< whose values were used
  std::vector<std::string> notes;      ///< what an operator should know
};

/// The level of the sea from the end of D on.
///
/// Where the store holds the provider's own forecast, published by the issue time, that is it, as
/// it is, as long as it lasts. Else, and from there on, it is the harmonic tide of the record up to
/// the end of D (`fit_level_tide`) and what is left of the departure from it (`SurgeMemory`), which
/// makes no jump where the provider ends. Its spread, and how long a departure lasts, are those of
/// the days before, had they been forecast (`hindcast_level`); the provider's is that of its own
/// past runs against the analysis that followed, 0.10 m where fewer than five of them can be judged
/// (estimate).
///
/// Means over six hours and more, and levels said to lack the tide, hold no level of any hour and
/// are left out, with a note. A record that shows no tide for want of three days gives none.
[[nodiscard]] LevelForecast forecast_level(const ScalarRecord& record, const ForecastPlan& plan);

}  // namespace slackwater::calibration
