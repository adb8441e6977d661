#include "api/pipeline/daily_job.h"

#include <nlohmann/json.hpp>

#include "api/pipeline/job_summary.h"
#include "api/program/version.h"
#include "ingest/cf/forecast/forecast_file.h"

namespace slackwater::api {

DailyJob daily_job(const SiteData& data, const calibration::ForecastOptions& options) {
  DailyJob job;
  calibration::ForecastOptions ours = options;
  ours.code_version = code_version();
  job.forecast = calibration::make_forecast(data, ours);
  job.site = data.site;
  job.dry_columns = data.dry_columns;
  job.horizon = options.horizon;
  return job;
}

store::FiledForecast publish(store::Store& store, const DailyJob& job, ForecastOrigin origin) {
  return publish(store, std::span(&job, 1), origin).front();
}

std::vector<store::FiledForecast> publish(store::Store& store, std::span<const DailyJob> jobs,
                                          ForecastOrigin origin) {
  std::vector<store::NewForecast> rows;
  for (const DailyJob& job : jobs) {
    const Snapshot& snapshot = job.forecast.snapshot;
    store::NewForecast row;
    row.content_file = store.staging_folder() / ("forecast-" + std::to_string(rows.size()) + ".nc");
    ingest::write_forecast(row.content_file, snapshot);
    row.row.site_id = snapshot.site_id;
    row.row.day = snapshot.day;
    row.row.issued = snapshot.issued;
    row.row.valid_from = snapshot.time.front();
    row.row.valid_to = snapshot.time.back();
    row.row.wind_policy = job.forecast.plan.wind;
    row.row.origin = origin;
    row.row.degraded = snapshot.degraded;
    row.row.headline = snapshot.headline;
    row.row.summary_json =
        job_summary(job).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    row.row.code_version = code_version();
    row.row.input_granules = job.forecast.input_granules;
    rows.push_back(std::move(row));
  }
  return store.commit_forecasts(rows);
}

}  // namespace slackwater::api
