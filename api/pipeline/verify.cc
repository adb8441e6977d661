#include "api/pipeline/verify.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "api/issued/as_issued.h"
#include "api/issued/in_force.h"
#include "api/pipeline/load_site_data.h"
#include "calibration/day/daily_forecast.h"
#include "fields/base/attempt.h"
#include "fields/base/error.h"
#include "fields/base/log.h"
#include "ingest/cf/forecast_file.h"

namespace slackwater::api {
namespace {

calibration::CurrentSource currents_of_summary(const std::string& summary_json) {
  const auto summary = nlohmann::json::parse(summary_json, nullptr, false);
  if (summary.is_discarded() || !summary.contains("dataset")) return {};
  return {summary["dataset"].get<std::string>(), summary.value("stands_in_for", std::string())};
}

bool is_wanted(const calibration::VerifyOptions& options, std::int64_t id) {
  return options.forecasts.empty() || std::find(options.forecasts.begin(), options.forecasts.end(),
                                                id) != options.forecasts.end();
}

struct Chosen {
  std::vector<store::ForecastRow> rows;
  std::vector<std::string> damaged;  ///< what was passed over, in words
};

/// Of each day and wind policy the one as issued whose file is whole, in order of day.
Chosen forecasts_to_score(store::Store& store, const Site& site,
                          const calibration::VerifyOptions& options) {
  store::ForecastQuery query;
  query.site_id = site.id;
  query.from_day = options.from;
  const std::vector<store::ForecastRow> of_site = store.find_forecasts(query);
  std::map<std::pair<UtcDay, WindPolicy>, std::vector<store::ForecastRow>> all;
  for (const store::ForecastRow& row : of_site) {
    if (options.to && row.day > *options.to) continue;
    if (options.only && row.origin != *options.only) continue;
    if (is_wanted(options, row.id) && row.issued < options.issued_before)
      all[{row.day, row.wind_policy}].push_back(row);
  }
  Chosen chosen;
  for (auto& [key, rows] : all) {
    for (store::ForecastRow& row : as_issued_first(std::move(rows), of_site)) {
      const auto damage = damage_of(store, row);
      if (!damage) {
        chosen.rows.push_back(std::move(row));
        break;
      }
      log_event(LogLevel::warning, "forecast not verified", {{"problem", *damage}});
      chosen.damaged.push_back(*damage);
    }
  }
  return chosen;
}

calibration::Verification score_all(const store::Store& store, const Chosen& chosen,
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
  const Chosen chosen = forecasts_to_score(store, site, options);
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
