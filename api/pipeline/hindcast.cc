#include "api/pipeline/hindcast.h"

#include "fields/base/error.h"

namespace slackwater::api {

using std::chrono::days;

namespace {

/// A hindcast is scored by its centre and spread; its members would be most of what it writes.
void drop_members(Snapshot& snapshot) {
  snapshot.members = 1;
  for (ForecastColumn& column : snapshot.columns) {
    column.member_m_s.clear();
    column.wind_member_m_s.clear();
  }
}

}  // namespace

HindcastReport hindcast(store::Store& store, const Site& site, const HindcastOptions& options,
                        const std::function<void(double)>& progress) {
  if (options.to < options.from) {
    throw Error(ErrorKind::usage, "found --from " + format_day(options.from) + " after --to " +
                                      format_day(options.to));
  }
  const UtcTime first(options.from);
  const UtcTime last = UtcTime(options.to) + days(1) + options.horizon;
  const SiteData data = load_site_data(store, site, first - history_read, last);
  HindcastReport report;
  Rehearsals rehearsals(data);
  std::vector<DailyForecast> forecasts;
  const double count = static_cast<double>((options.to - options.from).count() + 1);
  for (UtcDay day = options.from; day <= options.to; day += days(1)) {
    JobOptions job;
    job.day = day;
    job.issued = UtcTime(day) + days(1) + options.latency;
    job.horizon = options.horizon;
    job.wind = options.wind;
    job.origin = "hindcast";
    job.threads = options.threads;
    job.rehearsals = &rehearsals;
    if (!holds_day(data, day, job.issued)) {
      report.skipped.push_back(format_day(day) + ": no whole day of currents");
    } else {
      forecasts.push_back(make_forecast(data, job));
      drop_members(forecasts.back().snapshot);
    }
    if (progress) progress(0.8 * static_cast<double>((day - options.from).count() + 1) / count);
  }
  if (forecasts.empty()) {
    throw Error(ErrorKind::not_found, "the store holds no whole day of currents for site " +
                                          site.id + " from " + format_day(options.from) + " to " +
                                          format_day(options.to) +
                                          "; ingest current products of these days");
  }
  JobOptions job;
  job.origin = "hindcast";
  report.forecasts = publish(store, forecasts, job);
  for (std::size_t i = 0; i < forecasts.size(); ++i) {
    auto scored = score_forecast(data, forecasts[i].snapshot, forecasts[i].dataset, options.verify);
    report.skill.insert(report.skill.end(), scored.begin(), scored.end());
    if (progress)
      progress(0.8 + 0.2 * static_cast<double>(i + 1) / static_cast<double>(forecasts.size()));
  }
  return report;
}

}  // namespace slackwater::api
