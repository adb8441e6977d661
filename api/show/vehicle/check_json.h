#pragma once
#include <nlohmann/json_fwd.hpp>

#include "api/ask/vehicle/vehicle_check.h"

namespace slackwater::api {

/// m, m/s, W, s, degrees; eigenvalues as [rate, frequency] in 1/s. What there is not is null.
[[nodiscard]] nlohmann::json check_json(const VehicleCheck& check);

}  // namespace slackwater::api
