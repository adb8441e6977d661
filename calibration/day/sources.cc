#include "calibration/day/sources.h"

#include <algorithm>
#include <iterator>

#include "calibration/day/day_choice.h"
#include "calibration/provider/provider_runs.h"

namespace slackwater::calibration {

std::vector<SourceUse> sources_of(const Chosen<Horizontal>& known, const HorizonWind& wind,
                                  const HorizonSea& sea, const ForecastPlan& plan) {
  const UtcTime from(plan.day);
  const UtcTime to = plan.stamps.empty() ? plan.end_of_day() : plan.stamps.back();
  std::vector<SourceUse> all = uses_of("current", known.stretches, from, plan.end_of_day());
  const auto add = [&](const char* quantity, const std::vector<Stretch>& stretches, UtcTime until) {
    auto uses = uses_of(quantity, stretches, from, until);
    std::move(uses.begin(), uses.end(), std::back_inserter(all));
  };
  add("wind", wind.stretches, to);
  add("waves", sea.stretches, to);
  return all;
}

std::vector<SourceUse> layer_sources(const ColumnData& column, const ForecastPlan& plan) {
  return uses_of("mixed layer", layer_record(column, plan).stretches, UtcTime(plan.day),
                 plan.end_of_day());
}

std::vector<SourceUse> provider_sources(const ColumnData& column, const ForecastPlan& plan) {
  if (plan.stamps.empty()) return {};
  return uses_of(
      "current forecast",
      provider_runs(column.current, plan.dataset, plan.knowledge_of_runs(), plan.end_of_day())
          .stretches,
      plan.end_of_day(), plan.stamps.back());
}

Inputs inputs_of(const SiteData& data, const ForecastOptions& options) {
  std::vector<PartFailure> failures;
  const ForecastPlan plan = plan_of(data, options, choose_day(data, options, failures));
  if (data.columns.empty()) return {plan.day, {}};
  const ColumnData& column = data.columns.front();
  const HorizonWind wind =
      horizon_wind(column.wind, plan.wind, plan.end_of_day(), plan.stamps, plan.best);
  const HorizonSea sea =
      horizon_sea(column, data.site, plan.wind, plan.end_of_day(), plan.stamps, wind, plan.best);
  Inputs inputs{plan.day, sources_of(known_currents(column, plan), wind, sea, plan)};
  for (const auto& more : {provider_sources(column, plan), layer_sources(column, plan)})
    inputs.sources.insert(inputs.sources.end(), more.begin(), more.end());
  return inputs;
}

}  // namespace slackwater::calibration
