#include "calibration/day/sources.h"

#include <algorithm>
#include <iterator>

#include "calibration/day/column/methods.h"
#include "calibration/day/day_choice.h"

namespace slackwater::calibration {

std::vector<SourceUse> sources_of(const Chosen<Horizontal>& currents, const HorizonWind& wind,
                                  const HorizonSea& sea, const ProviderRuns& provider,
                                  const LayerRecord& layer, const ForecastPlan& plan) {
  const UtcTime start(plan.day);
  const UtcTime end_of_day = plan.end_of_day();
  const UtcTime horizon = plan.stamps.empty() ? end_of_day : plan.stamps.back();
  std::vector<SourceUse> all;
  const auto add = [&](const char* quantity, const std::vector<Stretch>& stretches, UtcTime from,
                       UtcTime to) {
    auto uses = uses_of(quantity, stretches, from, to);
    std::move(uses.begin(), uses.end(), std::back_inserter(all));
  };
  add("current", currents.stretches, start, end_of_day);
  add("wind", wind.stretches, start, horizon);
  add("waves", sea.stretches, start, horizon);
  if (!plan.stamps.empty() && provider.reaches_beyond(end_of_day))
    add("current forecast", provider.stretches, end_of_day, horizon);
  add("mixed layer", layer.values.stretches, start, end_of_day);
  return all;
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
  return {plan.day, sources_of(known_currents(column, plan).record, wind, sea,
                               known_provider(column, plan), layer_record(column, plan), plan)};
}

}  // namespace slackwater::calibration
