#include "api/pipeline/issue_forecast.h"

#include "api/issued/as_issued.h"
#include "api/pipeline/load_site_data.h"

namespace slackwater::api {
namespace {

ForecastOrigin origin_in(store::Store& store, const Snapshot& snapshot,
                         const calibration::ForecastOptions& options) {
  store::ForecastQuery since;
  since.site_id = snapshot.site_id;
  since.from_day = snapshot.day;
  return origin_of_run(snapshot.day, snapshot.issued, options.day.has_value(), options.hindsight,
                       store.find_forecasts(since));
}

}  // namespace

Issue issue_forecast(store::Store& store, const Site& site,
                     const calibration::ForecastOptions& options,
                     const std::function<void(const Snapshot&)>& look) {
  Issue issue;
  issue.data = std::make_shared<const SiteData>(load_site_data(store, site, options));
  issue.job = daily_job(*issue.data, options);
  const Snapshot& snapshot = issue.job.forecast.snapshot;
  if (look) look(snapshot);
  issue.origin = origin_in(store, snapshot, options);
  issue.filed = publish(store, issue.job, issue.origin);
  issue.past = verify_past(store, site, *issue.data, snapshot, options.wind);
  return issue;
}

}  // namespace slackwater::api
