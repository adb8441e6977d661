#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "calibration/day/daily_forecast.h"
#include "data/store/store.h"

namespace slackwater::api {

/// A forecast made, with what it was made of and for; not yet stored.
struct DailyJob {
  calibration::DailyForecast forecast;
  Site site;
  std::size_t dry_columns = 0;  ///< of the site, that are on land
  Duration horizon{0};          ///< beyond the end of D, as asked for
};

/// The daily job without the store: the forecast (calibration/day/daily_forecast.h), made by this
/// version of the program.
[[nodiscard]] DailyJob daily_job(const SiteData& data, const calibration::ForecastOptions& options);

/// Writes the forecast's file and stores it as issued, its summary (job_summary.h) beside it. A
/// forecast of the same inputs, options, site, program and issue time that is stored
/// already keeps its id: nothing is added.
store::FiledForecast publish(store::Store& store, const DailyJob& job, ForecastOrigin origin);
/// Several at once, all or none (hindcast).
std::vector<store::FiledForecast> publish(store::Store& store, std::span<const DailyJob> jobs,
                                          ForecastOrigin origin);

}  // namespace slackwater::api
