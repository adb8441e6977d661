#pragma once
#include <optional>
#include <variant>

#include "fields/base/config.h"
#include "twin/scenario/scenario.h"

namespace slackwater::twin {

// What vehicles are in. All throw Error(invalid_input) with file and line.

/// `water` of a scenario.
[[nodiscard]] std::variant<ForecastWater, MadeUpWater> read_water(const Config& scenario);
/// `waves` of a scenario. @param depth_m  of made-up water; nothing: the water is of a forecast
[[nodiscard]] ScenarioWaves read_waves(const Config& scenario, std::optional<double> depth_m);
/// An entry of `structures`.
[[nodiscard]] ScenarioStructure read_structure(const Config& config);

}  // namespace slackwater::twin
