#include "api/pipeline/verify.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "api/issued/in_force.h"
#include "api/pipeline/load_site_data.h"
#include "calibration/day/daily_forecast.h"
#include "fields/base/error.h"
#include "ingest/cf/forecast_file.h"

namespace slackwater::api {
namespace {

std::string dataset_of_summary(const std::string& summary_json) {
  const auto summary = nlohmann::json::parse(summary_json, nullptr, false);
  if (summary.is_discarded() || !summary.contains("dataset")) return {};
  return summary["dataset"].get<std::string>();
}

bool is_wanted(const calibration::VerifyOptions& options, std::int64_t id) {
  return options.forecasts.empty() || std::find(options.forecasts.begin(), options.forecasts.end(),
                                                id) != options.forecasts.end();
}

/// The one in force of each day and wind policy, in order of day.
std::vector<store::ForecastRow> forecasts_to_score(store::Store& store, const Site& site,
                                                   const calibration::VerifyOptions& options) {
  store::ForecastQuery query;
  query.site_id = site.id;
  query.from_day = options.from;
  query.to_day = options.to;
  std::map<std::pair<UtcDay, WindPolicy>, store::ForecastRow> in_force;
  for (store::ForecastRow& row : store.find_forecasts(query)) {
    if (!is_wanted(options, row.id) || row.issued >= options.issued_before) continue;
    const auto [found, is_new] = in_force.try_emplace({row.day, row.wind_policy}, row);
    if (!is_new && has_more_force(row, found->second)) found->second = std::move(row);
  }
  std::vector<store::ForecastRow> rows;
  rows.reserve(in_force.size());
  for (auto& [key, row] : in_force) rows.push_back(std::move(row));
  return rows;
}

calibration::Verification score_all(const store::Store& store,
                                    const std::vector<store::ForecastRow>& rows,
                                    const SiteData& data,
                                    const calibration::VerifyOptions& options) {
  calibration::Verification result;
  for (const store::ForecastRow& row : rows) {
    const Snapshot snapshot = ingest::read_forecast(store.content_path(row.content_sha256));
    calibration::ForecastSkill skill =
        calibration::score_forecast(data, snapshot, dataset_of_summary(row.summary_json), options);
    std::move(skill.entries.begin(), skill.entries.end(), std::back_inserter(result.entries));
    if (skill.trace) result.traces.push_back(std::move(*skill.trace));
  }
  return result;
}

}  // namespace

calibration::Verification verify_with(store::Store& store, const Site& site, const SiteData& data,
                                      const calibration::VerifyOptions& options) {
  return score_all(store, forecasts_to_score(store, site, options), data, options);
}

calibration::Verification verify(store::Store& store, const Site& site,
                                 const calibration::VerifyOptions& options) {
  const std::vector<store::ForecastRow> rows = forecasts_to_score(store, site, options);
  if (rows.empty()) {
    throw Error(ErrorKind::not_found,
                "found no issued forecast for site " + site.id +
                    " in this range; run `slackwater forecast` or `slackwater hindcast` first");
  }
  UtcTime to = UtcTime::min();
  for (const store::ForecastRow& row : rows) to = std::max(to, row.valid_to);
  const SiteData data =
      load_site_data(store, site, UtcTime(rows.front().day) - calibration::history_wanted, to);
  return score_all(store, rows, data, options);
}

}  // namespace slackwater::api
