#pragma once
#include <functional>
#include <string>
#include <vector>

#include "api/issued/issued_fields.h"

// How old the forecasts are that answer: for the list of sites, for `/health` and `/metrics`.

namespace slackwater::api {

/// The present moment of the machine.
[[nodiscard]] UtcTime machine_time();

/// When a forecast counts as old.
struct Freshness {
  /// A daily job that ran at 05:00 is 24 h old when the next one begins; half a day more lets that
  /// be late or wait for its inputs, and one missed run is noticed the same afternoon.
  Duration stale_after = std::chrono::hours(36);
  std::function<UtcTime()> now = machine_time;
};

/// What is to be said of a site, the worst first.
enum class SiteCondition {
  unreadable,  ///< it has forecasts, none of which can be read now
  stale,       ///< the newest forecast is older than the limit, or its last hour has passed
  degraded,    ///< fresh, but made without all that it wants; its headline says without what
  hindcast,    ///< it was only ever forecast in hindsight: no job is late
  ok
};
[[nodiscard]] std::string_view name_of(SiteCondition condition) noexcept;

/// The forecast in force of a site as it stands at one moment.
struct SiteState {
  std::string site_id;
  std::string site_name;
  IssuedForecast forecast;  ///< in force; of an unreadable site the one that should be
  Duration age{};           ///< since its issue; negative where that is ahead of the clock
  SiteCondition condition = SiteCondition::ok;
};

/// Every site of the catalogue, by site id.
[[nodiscard]] std::vector<SiteState> site_states(const ForecastCatalogue& catalogue,
                                                 const Freshness& freshness);

/// "4 min", "5 h", "3 days": rounded down, in the largest unit that leaves two or more.
[[nodiscard]] std::string age_in_words(Duration age);

/// Some sentences for people: how old it is, what is wrong with it, and its headline.
[[nodiscard]] std::string in_words(const SiteState& state, const Freshness& freshness);

}  // namespace slackwater::api
