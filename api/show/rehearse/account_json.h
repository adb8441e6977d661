#pragma once
#include <nlohmann/json_fwd.hpp>

#include "twin/account/vehicle_account.h"

namespace slackwater::api {

/// A vehicle's account as `simulate --json` has it (api/docs/json.md).
[[nodiscard]] nlohmann::json account_json(const twin::VehicleAccount& vehicle, UtcTime start);
/// The same as `score --json` has it.
[[nodiscard]] nlohmann::json score_json(const twin::VehicleAccount& vehicle, double ran_s);

}  // namespace slackwater::api
