#include "api/pipeline/verify.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "api/pipeline/daily_job.h"
#include "api/pipeline/surface_skill.h"
#include "fields/base/error.h"
#include "ingest/cf/forecast_file.h"

namespace slackwater::api {
namespace {

std::string dataset_of_summary(const std::string& summary_json) {
  const auto summary = nlohmann::json::parse(summary_json, nullptr, false);
  if (summary.is_discarded() || !summary.contains("dataset")) return {};
  return summary["dataset"].get<std::string>();
}

ForecastSkill score_one(const SiteData& data, const Snapshot& snapshot, const std::string& dataset,
                        const VerifyOptions& options) {
  SkillEntry blank;
  blank.variable = "sea_water_velocity";
  blank.site = snapshot.site_id;
  blank.day = snapshot.day;
  blank.issued = snapshot.issued;
  blank.wind = snapshot.wind_policy;
  ForecastSkill skill = score_currents(data, snapshot, dataset, options, blank);
  if (data.columns.empty() || snapshot.columns.empty()) return skill;
  const UtcTime end = UtcTime(snapshot.day) + std::chrono::days(1);
  auto surface = score_surface(data.columns.front(), snapshot, end, options, blank);
  std::move(surface.begin(), surface.end(), std::back_inserter(skill.entries));
  return skill;
}

bool is_wanted(const VerifyOptions& options, std::int64_t id) {
  return options.forecasts.empty() || std::find(options.forecasts.begin(), options.forecasts.end(),
                                                id) != options.forecasts.end();
}

/// The last issued of each day and wind policy, in order of day.
std::vector<store::ForecastRow> forecasts_to_score(store::Store& store, const Site& site,
                                                   const VerifyOptions& options) {
  store::ForecastQuery query;
  query.site_id = site.id;
  query.from_day = options.from;
  query.to_day = options.to;
  std::map<std::pair<UtcDay, std::string>, store::ForecastRow> last;
  for (store::ForecastRow& row : store.find_forecasts(query)) {
    if (is_wanted(options, row.id))
      last.insert_or_assign({row.day, row.wind_policy}, std::move(row));
  }
  std::vector<store::ForecastRow> rows;
  for (auto& [key, row] : last) rows.push_back(std::move(row));
  return rows;
}

Verification score_all(const store::Store& store, const std::vector<store::ForecastRow>& rows,
                       const SiteData& data, const VerifyOptions& options) {
  Verification result;
  for (const store::ForecastRow& row : rows) {
    const Snapshot snapshot = ingest::read_forecast(store.content_path(row.content_sha256));
    ForecastSkill skill = score_one(data, snapshot, dataset_of_summary(row.summary_json), options);
    std::move(skill.entries.begin(), skill.entries.end(), std::back_inserter(result.entries));
    if (skill.trace) result.traces.push_back(std::move(*skill.trace));
  }
  return result;
}

}  // namespace

std::vector<SkillEntry> score_forecast(const SiteData& data, const Snapshot& snapshot,
                                       const std::string& dataset, const VerifyOptions& options) {
  return score_one(data, snapshot, dataset, options).entries;
}

std::vector<SkillEntry> verify_with(store::Store& store, const Site& site, const SiteData& data,
                                    const VerifyOptions& options) {
  return score_all(store, forecasts_to_score(store, site, options), data, options).entries;
}

Verification verification(store::Store& store, const Site& site, const VerifyOptions& options) {
  const std::vector<store::ForecastRow> rows = forecasts_to_score(store, site, options);
  if (rows.empty()) {
    throw Error(ErrorKind::not_found,
                "found no issued forecast for site " + site.id +
                    " in this range; run `slackwater forecast` or `slackwater hindcast` first");
  }
  UtcTime to = UtcTime::min();
  for (const store::ForecastRow& row : rows) to = std::max(to, row.valid_to);
  const SiteData data = load_site_data(store, site, UtcTime(rows.front().day) - history_read, to);
  return score_all(store, rows, data, options);
}

std::vector<SkillEntry> verify(store::Store& store, const Site& site,
                               const VerifyOptions& options) {
  return verification(store, site, options).entries;
}

}  // namespace slackwater::api
