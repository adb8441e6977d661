#include "api/door/cli/serve/serve_health.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace slackwater::api {
namespace {

double seconds(Duration duration) { return std::chrono::duration<double>(duration).count(); }

bool is_late(const SiteState& site) {
  return site.condition == SiteCondition::stale || site.condition == SiteCondition::unreadable;
}

nlohmann::ordered_json details_of(const std::vector<SiteState>& sites, const Freshness& freshness) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const SiteState& site : sites) {
    list.push_back({{"site", site.site_id},
                    {"status", name_of(site.condition)},
                    {"forecast", site.forecast.instance},
                    {"issued", format_utc(site.forecast.row.issued)},
                    {"valid_to", format_utc(site.forecast.row.valid_to)},
                    {"age_s", seconds(site.age)},
                    {"degraded", site.forecast.row.degraded},
                    {"in_words", in_words(site, freshness)}});
  }
  return {{"stale_after_s", seconds(freshness.stale_after)}, {"sites", std::move(list)}};
}

}  // namespace

http::HealthFacts health_of(const IssuedFields& forecasts, const Freshness& freshness) {
  http::HealthFacts health;
  const std::shared_ptr<const ForecastCatalogue> catalogue = forecasts.catalogue();
  const std::vector<SiteState> sites = site_states(*catalogue, freshness);
  const std::string trouble = forecasts.trouble();
  const bool any_late = std::any_of(sites.begin(), sites.end(), is_late);
  const bool any_degraded = std::any_of(sites.begin(), sites.end(), [](const SiteState& site) {
    return site.condition == SiteCondition::degraded;
  });
  health.can_serve = forecasts.is_following();
  health.is_current = !sites.empty() && !any_late;
  health.status = !health.can_serve                  ? "unavailable"
                  : sites.empty()                    ? "empty"
                  : any_late                         ? "stale"
                  : any_degraded || !trouble.empty() ? "degraded"
                                                     : "ok";
  if (!trouble.empty()) health.facts.emplace_back("store", trouble);
  health.facts.emplace_back("forecasts", std::to_string(catalogue->instances.size()));
  if (!catalogue->instances.empty()) {
    const IssuedForecast& newest = catalogue->instances.front();
    health.facts.emplace_back("newest_forecast", newest.instance);
    health.facts.emplace_back("newest_issued", format_utc(newest.row.issued));
  }
  health.details = details_of(sites, freshness);
  return health;
}

std::vector<http::Gauge> forecast_gauges(const ForecastCatalogue& catalogue,
                                         const Freshness& freshness) {
  http::Gauge age{
      "slackwater_forecast_age_seconds", "Since the issue of the forecast in force.", "site", {}};
  http::Gauge stale{"slackwater_forecast_stale",
                    "1 where it is older than --stale-after, has ended, or cannot be read.",
                    "site",
                    {}};
  http::Gauge degraded{"slackwater_forecast_degraded",
                       "1 where the forecast in force was made without all its inputs.",
                       "site",
                       {}};
  for (const SiteState& site : site_states(catalogue, freshness)) {
    stale.values.emplace_back(site.site_id, is_late(site) ? 1 : 0);
    // What cannot be read answers nobody: its age would say that all is well.
    if (site.condition == SiteCondition::unreadable) continue;
    age.values.emplace_back(site.site_id, seconds(site.age));
    degraded.values.emplace_back(site.site_id, site.forecast.row.degraded ? 1 : 0);
  }
  return {std::move(age), std::move(stale), std::move(degraded)};
}

}  // namespace slackwater::api
