#pragma once
#include <vector>

#include "fields/service/snapshot.h"

namespace slackwater {

/// The spread of the wave heights of a column, per time (`ForecastColumn::height_spread`). Of a
/// forecast that says none, that of a provider's forecasts of its lead; NaN where there is no
/// height. Empty without waves.
[[nodiscard]] std::vector<double> height_spread_of(const Snapshot& snapshot,
                                                   const ForecastColumn& column);

}  // namespace slackwater
