#include "api/pipeline/hindcast.h"

#include "api/pipeline/load_site_data.h"
#include "calibration/day/leading_day.h"
#include "fields/base/attempt.h"
#include "fields/base/error.h"

namespace slackwater::api {

using std::chrono::days;

namespace {

/// A hindcast is scored by its centre and spread; its members would be most of what it writes.
void drop_members(Snapshot& snapshot) {
  snapshot.members = 1;
  snapshot.wind_ensemble.clear();
  for (ForecastColumn& column : snapshot.columns) {
    column.member_m_s.clear();
    column.wind_member_m_s.clear();
    column.wind_member_number.clear();
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
  const SiteData data = load_site_data(store, site, first - calibration::history_wanted, last);
  HindcastReport report;
  calibration::RehearsedDays rehearsals(data, options.parts.of_column);
  calibration::VerifyOptions verify = options.verify;
  verify.from_archive = true;
  verify.origin = ForecastOrigin::hindcast;
  std::vector<DailyJob> jobs;
  std::optional<Failure> first_failure;
  const double count = static_cast<double>((options.to - options.from).count() + 1);
  for (UtcDay day = options.from; day <= options.to; day += days(1)) {
    calibration::ForecastOptions job;
    job.day = day;
    job.issued = UtcTime(day) + days(1) + options.latency;
    job.horizon = options.horizon;
    job.wind = options.wind;
    job.hindsight = options.wind == WindPolicy::best;
    job.simulate_wind = options.simulate_wind && options.wind == WindPolicy::forecast;
    job.seed = options.seed;
    job.threads = options.threads;
    job.rehearsals = &rehearsals;
    job.parts = options.parts;
    const auto failure = attempt([&] {
      const auto leading = calibration::leading_day(data, {job.issued, UtcTime::max(), day});
      if (!leading || leading->day != day) {
        report.skipped.push_back(format_day(day) + ": no whole day of currents");
        return;
      }
      DailyJob made = daily_job(data, job);
      drop_members(made.forecast.snapshot);
      if (made.forecast.snapshot.simulated_wind) ++report.simulated_winds;
      jobs.push_back(std::move(made));
    });
    if (failure) {
      report.skipped.push_back(format_day(day) + ": " + failure->why);
      if (!first_failure) first_failure = failure;
    }
    if (progress) progress(0.8 * static_cast<double>((day - options.from).count() + 1) / count);
  }
  if (jobs.empty() && first_failure) {
    throw Error(first_failure->kind, "no day from " + format_day(options.from) + " to " +
                                         format_day(options.to) + " could be forecast; " +
                                         report.skipped.back());
  }
  if (jobs.empty()) {
    throw Error(ErrorKind::not_found, "the store holds no whole day of currents for site " +
                                          site.id + " from " + format_day(options.from) + " to " +
                                          format_day(options.to) +
                                          "; ingest current products of these days");
  }
  for (const store::FiledForecast& filed : publish(store, jobs, ForecastOrigin::hindcast))
    report.forecasts.push_back(filed.id);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const calibration::DailyForecast& forecast = jobs[i].forecast;
    std::vector<calibration::SkillEntry> scored;
    const auto failure = attempt([&] {
      scored =
          calibration::score_forecast(data, forecast.snapshot,
                                      {forecast.plan.dataset, forecast.plan.stands_in_for}, verify)
              .entries;
    });
    if (failure) report.unscored.push_back(format_day(forecast.plan.day) + ": " + failure->why);
    report.skill.insert(report.skill.end(), scored.begin(), scored.end());
    if (progress)
      progress(0.8 + 0.2 * static_cast<double>(i + 1) / static_cast<double>(jobs.size()));
  }
  return report;
}

}  // namespace slackwater::api
