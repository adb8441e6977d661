#pragma once
#include <span>

#include "data/store/store.h"
#include "ingest/cf/forecast/forecast_file.h"

namespace slackwater::tests {

/// Issues a made-up forecast into a store, as the daily job would have.
/// @return its id
inline std::int64_t commit_made_up(store::Store& store, const Snapshot& made,
                                   ForecastOrigin origin = ForecastOrigin::forecast) {
  store::NewForecast row;
  row.content_file = store.staging_folder() / "made_up.nc";
  ingest::write_forecast(row.content_file, made);
  row.row.site_id = made.site_id;
  row.row.day = made.day;
  row.row.issued = made.issued;
  row.row.valid_from = made.time.front();
  row.row.valid_to = made.time.back();
  row.row.wind_policy = made.wind_policy.value();
  row.row.origin = origin;
  row.row.headline = made.headline;
  row.row.degraded = made.degraded;
  row.row.summary_json = "{}";
  row.row.code_version = "test";
  return store.commit_forecasts(std::span(&row, 1)).front().id;
}

}  // namespace slackwater::tests
