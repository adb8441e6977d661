#pragma once
#include <vector>

#include "calibration/day/daily_forecast.h"
#include "calibration/provider/provider_runs.h"
#include "fields/record/source_use.h"

namespace slackwater::calibration {

/// Who speaks for the currents, wind and waves of a column, the provider's own forecast of the
/// currents beyond D, and the mixed layer on D: when and why, from the start of D to the end of the
/// horizon.
[[nodiscard]] std::vector<SourceUse> sources_of(const Chosen<Horizontal>& currents,
                                                const HorizonWind& wind, const HorizonSea& sea,
                                                const ProviderRuns& provider,
                                                const LayerRecord& layer, const ForecastPlan& plan);

/// What a forecast would be made from.
struct Inputs {
  UtcDay day{};  ///< D
  std::vector<SourceUse> sources;
};

/// The same before any forecast is made, at the first column.
[[nodiscard]] Inputs inputs_of(const SiteData& data, const ForecastOptions& options);

}  // namespace slackwater::calibration
