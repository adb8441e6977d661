#pragma once
#include "fields/base/config.h"
#include "twin/scenario/scenario.h"

namespace slackwater::twin {

/// An entry of `tasks`. @throws Error(invalid_input) with file and line
[[nodiscard]] ScenarioTask read_task(const Config& config);

}  // namespace slackwater::twin
