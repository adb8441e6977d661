#include "api/pipeline/verify.h"

#include "api/pipeline/forecasts_to_score.h"
#include "api/pipeline/load_site_data.h"
#include "calibration/day/daily_forecast.h"
#include "fields/base/attempt.h"
#include "fields/base/error.h"
#include "fields/base/log.h"
#include "ingest/cf/forecast/forecast_file.h"

namespace slackwater::api {
namespace {

calibration::Verification score_all(const store::Store& store, const ForecastsToScore& chosen,
                                    const SiteData& data,
                                    const calibration::VerifyOptions& options) {
  calibration::Verification result;
  result.unscored = chosen.damaged;
  std::optional<Failure> last_failure;
  std::size_t scored = 0;
  for (const store::ForecastRow& row : chosen.rows) {
    calibration::ForecastSkill skill;
    calibration::VerifyOptions of_row = options;
    of_row.origin = row.origin;
    of_row.from_archive = options.from_archive || row.origin != ForecastOrigin::forecast;
    const auto failure = attempt([&] {
      const Snapshot snapshot = ingest::read_forecast(store.proven_content(row.content_sha256));
      skill = calibration::score_forecast(data, snapshot, currents_of_summary(row.summary_json),
                                          of_row);
    });
    if (failure) {
      result.unscored.push_back("forecast " + std::to_string(row.id) + " of day " +
                                format_day(row.day) + ": " + failure->why);
      last_failure = failure;
      continue;
    }
    ++scored;
    std::move(skill.entries.begin(), skill.entries.end(), std::back_inserter(result.entries));
    if (skill.trace) result.traces.push_back(std::move(*skill.trace));
  }
  if (last_failure && scored == 0)
    throw Error(last_failure->kind, "no forecast could be scored; " + result.unscored.back());
  return result;
}

}  // namespace

calibration::Verification verify_with(store::Store& store, const Site& site, const SiteData& data,
                                      const calibration::VerifyOptions& options) {
  return score_all(store, forecasts_to_score(store, site, options), data, options);
}

calibration::Verification verify(store::Store& store, const Site& site,
                                 const calibration::VerifyOptions& options) {
  const ForecastsToScore chosen = forecasts_to_score(store, site, options);
  if (chosen.rows.empty() && !chosen.damaged.empty())
    throw Error(ErrorKind::invalid_input, chosen.damaged.front());
  if (chosen.rows.empty()) {
    throw Error(ErrorKind::not_found,
                "found no issued forecast for site " + site.id +
                    " in this range; run `slackwater forecast` or `slackwater hindcast` first");
  }
  UtcTime to = UtcTime::min();
  for (const store::ForecastRow& row : chosen.rows) to = std::max(to, row.valid_to);
  const SiteData data = load_site_data(
      store, site, UtcTime(chosen.rows.front().day) - calibration::history_wanted, to);
  return score_all(store, chosen, data, options);
}

}  // namespace slackwater::api
