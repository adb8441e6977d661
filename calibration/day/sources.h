#pragma once
#include <vector>

#include "calibration/day/daily_forecast.h"
#include "fields/record/source_use.h"

namespace slackwater::calibration {

/// What the inputs of a column are, from the start of D to the end of the horizon: currents, wind,
/// waves and mixed layer, with who speaks when and why.
[[nodiscard]] std::vector<SourceUse> sources_of(const Chosen<Horizontal>& known,
                                                const HorizonWind& wind, const HorizonSea& sea,
                                                const std::vector<Stretch>& layer,
                                                const ForecastPlan& plan);

/// What a forecast would be made from.
struct Inputs {
  UtcDay day{};  ///< D
  std::vector<SourceUse> sources;
};

/// The same before any forecast is made, at the first column.
[[nodiscard]] Inputs inputs_of(const SiteData& data, const ForecastOptions& options);

}  // namespace slackwater::calibration
