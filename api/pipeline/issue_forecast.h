#pragma once
#include <functional>
#include <memory>

#include "api/pipeline/daily_job.h"
#include "api/pipeline/past_skill.h"

namespace slackwater::api {

/// A forecast that was made and filed, and how the ones before it did.
struct Issue {
  std::shared_ptr<const SiteData> data;  ///< that it was made from, which owns the job's origins
  DailyJob job;
  ForecastOrigin origin = ForecastOrigin::forecast;  ///< how it was filed
  store::FiledForecast filed;
  PastSkill past;
};

/// The order of a day: the site's data are read, the forecast is made and looked at, then filed as
/// a forecast or as a hindcast (`origin_of_run`); at last the forecasts before it are scored, as
/// far as their truth is in.
/// @param look  sees the forecast before it is filed; what it throws keeps it out of the store
/// @throws as `load_site_data` and `calibration::make_forecast`
[[nodiscard]] Issue issue_forecast(store::Store& store, const Site& site,
                                   const calibration::ForecastOptions& options,
                                   const std::function<void(const Snapshot&)>& look = {});

}  // namespace slackwater::api
