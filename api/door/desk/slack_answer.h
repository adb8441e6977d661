#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "api/issued/issued_fields.h"

namespace slackwater::api::desk {

/// When the current at a place and depth is likely below a speed, of the forecast in force of a
/// site. Words: depth (m, default 5), below (m/s, default 0.5), longitude and latitude (degrees,
/// default the first column).
/// @throws Error(not_found) for a site without a forecast, a place that it does not reach, a depth
///         below the bed; Error(usage)
[[nodiscard]] nlohmann::json slack_answer(const IssuedFields& forecasts, const std::string& site,
                                          const std::string& query);

}  // namespace slackwater::api::desk
