#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "calibration/day/daily_forecast.h"
#include "data/store/store.h"

namespace slackwater::api {

/// A forecast made, with what is filed beside it; not yet stored.
struct DailyJob {
  calibration::DailyForecast forecast;
  std::string summary_json;  ///< calibration report, inputs, effective configuration
};

/// The daily job without the store: the forecast (calibration/day/daily_forecast.h), made by this
/// version of the program, and its summary.
[[nodiscard]] DailyJob daily_job(const SiteData& data, const calibration::ForecastOptions& options);

/// Writes the forecast's file and stores it as issued. A forecast of the same inputs, options,
/// site, program and issue time that is stored already keeps its id: nothing is added.
store::FiledForecast publish(store::Store& store, const DailyJob& job, ForecastOrigin origin);
/// Several at once, all or none (hindcast).
std::vector<store::FiledForecast> publish(store::Store& store, std::span<const DailyJob> jobs,
                                          ForecastOrigin origin);

}  // namespace slackwater::api
