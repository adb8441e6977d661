#pragma once
#include <nlohmann/json_fwd.hpp>

#include "twin/scenario/scenario.h"

namespace slackwater::api {

/// Bounds to draw into what a vehicle feels: of `current`, `wind` (m/s) and `waves` (m) the
/// strictest upper limit of its conduct; no key where there is none. A limit with a table has no
/// one bound and is left out.
[[nodiscard]] nlohmann::json limit_bounds_json(const twin::ScenarioVehicle& vehicle);

}  // namespace slackwater::api
