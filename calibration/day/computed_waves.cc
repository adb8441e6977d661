#include "calibration/day/computed_waves.h"

#include <algorithm>
#include <cmath>

#include "fields/base/attempt.h"
#include "fields/base/text.h"

namespace slackwater::calibration {
namespace {

/// Of the provider, or measured.
bool is_given(DataStatus source) {
  return source != DataStatus::persisted && source != DataStatus::modelled;
}

struct ComputedHours {
  std::size_t count = 0;
  double highest_m = 0;
};

ComputedHours computed_hours(const std::vector<SeaState>& sea,
                             const std::vector<DataStatus>& source) {
  ComputedHours hours;
  for (std::size_t t = 0; t < sea.size(); ++t) {
    if (is_given(source[t]) || std::isnan(sea[t].significant_height_m)) continue;
    ++hours.count;
    hours.highest_m = std::max(hours.highest_m, sea[t].significant_height_m);
  }
  return hours;
}

/// The highest computed wave had the fetch been another; nothing where that cannot be had.
std::optional<double> highest_over(const Fetch& fetch, const ColumnData& column, const Site& site,
                                   const ForecastPlan& plan, const ColumnParts& parts) {
  std::optional<double> highest_m;
  Site other = site;
  other.fetch = fetch;
  const auto failure = attempt([&] {
    const HorizonWind wind =
        parts.wind(column.wind, plan.wind, plan.end_of_day(), plan.stamps, plan.best);
    const HorizonSea sea =
        parts.waves(column, other, plan.wind, plan.end_of_day(), plan.stamps, wind, plan.best);
    highest_m = computed_hours(sea.sea, sea.source).highest_m;
  });
  return failure ? std::nullopt : highest_m;
}

}  // namespace

std::optional<ComputedWaves> computed_waves(const ColumnForecast& made, const ColumnData& column,
                                            const Site& site, const ForecastPlan& plan,
                                            const ColumnParts& parts) {
  const ForecastColumn& out = made.column;
  const ComputedHours hours = computed_hours(out.sea, out.sea_source);
  if (hours.count == 0) return std::nullopt;
  ComputedWaves waves;
  waves.hours = hours.count;
  waves.of_hours = out.sea.size();
  waves.of_wind_alone = made.waves_of_wind_alone;
  waves.is_kept = out.wind_m_s.empty();
  waves.highest_m = hours.highest_m;
  waves.is_fetch_assumed = !site.fetch;
  if (site.fetch) waves.fetch = *site.fetch;
  if (waves.is_fetch_assumed && !waves.is_kept) {
    waves.highest_half_fetch_m = highest_over(waves.fetch.times(0.5), column, site, plan, parts);
    waves.highest_twice_fetch_m = highest_over(waves.fetch.times(2.0), column, site, plan, parts);
  }
  return waves;
}

bool is_degradation(const ComputedWaves& waves, WindPolicy policy) noexcept {
  constexpr std::size_t end_of_a_product_h = 6;
  if (waves.of_wind_alone) return true;
  return policy != WindPolicy::persist && waves.hours > end_of_a_product_h;
}

std::string text_of(const ComputedWaves& waves) {
  const std::string hours =
      std::to_string(waves.hours) + " of " + std::to_string(waves.of_hours) + " hours";
  if (waves.is_kept)
    return "the waves of " + hours +
           " are the last ones known: no newer waves and no wind are stored";
  std::string text =
      waves.of_wind_alone
          ? "no wave product is stored: the waves are computed from the wind alone, without swell"
          : "the waves of " + hours +
                " are computed from the wind: no wave product is stored for these hours";
  if (!waves.is_fetch_assumed) return text + "; fetch " + waves.fetch.text();
  text += "; a fetch of " + waves.fetch.text() + " is assumed (fetch_km in the site's file)";
  if (waves.highest_half_fetch_m && waves.highest_twice_fetch_m) {
    text += formatted(
        ": significant height up to {:.1f} m; with half this fetch {:.1f} m, with twice this fetch "
        "{:.1f} m",
        waves.highest_m, *waves.highest_half_fetch_m, *waves.highest_twice_fetch_m);
  }
  return text;
}

}  // namespace slackwater::calibration
