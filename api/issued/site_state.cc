#include "api/issued/site_state.h"

#include <algorithm>
#include <set>

#include "api/issued/in_force.h"

namespace slackwater::api {
namespace {

using namespace std::chrono;

/// Of the forecasts of a site, the one that should answer.
const IssuedForecast* strongest(const ForecastCatalogue& catalogue, const std::string& site) {
  const IssuedForecast* found = nullptr;
  for (const IssuedForecast& forecast : catalogue.instances) {
    if (forecast.row.site_id != site) continue;
    if (found == nullptr || has_more_force(forecast.row, found->row)) found = &forecast;
  }
  return found;
}

SiteCondition condition_of(const store::ForecastRow& row, UtcTime now, Duration stale_after) {
  if (row.origin != ForecastOrigin::forecast) return SiteCondition::hindcast;
  if (now - row.issued > stale_after || row.valid_to < now) return SiteCondition::stale;
  return row.degraded ? SiteCondition::degraded : SiteCondition::ok;
}

}  // namespace

UtcTime machine_time() { return time_point_cast<Duration>(system_clock::now()); }

std::string_view name_of(SiteCondition condition) noexcept {
  switch (condition) {
    case SiteCondition::unreadable:
      return "unreadable";
    case SiteCondition::stale:
      return "stale";
    case SiteCondition::degraded:
      return "degraded";
    case SiteCondition::hindcast:
      return "hindcast";
    case SiteCondition::ok:
      return "ok";
  }
  return "ok";
}

std::vector<SiteState> site_states(const ForecastCatalogue& catalogue, const Freshness& freshness) {
  const UtcTime now = freshness.now();
  std::set<std::string> sites;
  for (const IssuedForecast& forecast : catalogue.instances) sites.insert(forecast.row.site_id);
  std::vector<SiteState> states;
  for (const std::string& id : sites) {
    SiteState state{id, id, *strongest(catalogue, id), {}, SiteCondition::unreadable};
    const auto served = std::find_if(catalogue.sites.begin(), catalogue.sites.end(),
                                     [&](const auto& site) { return site.site_id == id; });
    if (served != catalogue.sites.end()) {
      state.site_name = served->field->snapshot().site_name;
      if (const IssuedForecast* forecast = catalogue.find(served->instance))
        state.forecast = *forecast;
      state.condition = condition_of(state.forecast.row, now, freshness.stale_after);
    }
    state.age = now - state.forecast.row.issued;
    states.push_back(std::move(state));
  }
  return states;
}

std::string age_in_words(Duration age) {
  const Duration size = abs(age);
  const auto counted = [](auto count, const char* unit) {
    return std::to_string(count.count()) + unit;
  };
  if (size >= days(2)) return counted(floor<days>(size), " days");
  if (size >= hours(2)) return counted(floor<hours>(size), " h");
  return counted(floor<minutes>(size), " min");
}

std::string in_words(const SiteState& state, const Freshness& freshness) {
  const store::ForecastRow& row = state.forecast.row;
  if (state.condition == SiteCondition::unreadable) {
    return "None of its forecasts can be read; the newest was issued " + format_utc(row.issued) +
           ". Run `slackwater store check`.";
  }
  std::string text = state.age < Duration(0)
                         ? "Issued " + age_in_words(state.age) +
                               " in the future by this machine's clock: check the clock."
                         : "Issued " + age_in_words(state.age) + " ago.";
  if (state.condition == SiteCondition::hindcast)
    return text + " Made in hindsight; no forecast was issued for this site.";
  if (state.condition == SiteCondition::stale) {
    text += row.valid_to < state.age + row.issued
                ? " Old: its last hour, " + format_utc(row.valid_to) + ", has passed."
                : " Old: a forecast should be no older than " +
                      age_in_words(freshness.stale_after) + ".";
    text += " See why the daily job did not run.";
  }
  if (row.degraded) text += " Degraded:";
  return row.headline.empty() ? text : text + " " + row.headline;
}

}  // namespace slackwater::api
