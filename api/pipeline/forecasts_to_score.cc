#include "api/pipeline/forecasts_to_score.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "api/issued/as_issued.h"
#include "api/issued/in_force.h"
#include "fields/base/log.h"

namespace slackwater::api {
namespace {

bool is_wanted(const calibration::VerifyOptions& options, std::int64_t id) {
  return options.forecasts.empty() || std::find(options.forecasts.begin(), options.forecasts.end(),
                                                id) != options.forecasts.end();
}

}  // namespace

ForecastsToScore forecasts_to_score(store::Store& store, const Site& site,
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
  ForecastsToScore chosen;
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

calibration::CurrentSource currents_of_summary(const std::string& summary_json) {
  const auto summary = nlohmann::json::parse(summary_json, nullptr, false);
  if (summary.is_discarded() || !summary.contains("dataset")) return {};
  return {summary["dataset"].get<std::string>(), summary.value("stands_in_for", std::string())};
}

}  // namespace slackwater::api
