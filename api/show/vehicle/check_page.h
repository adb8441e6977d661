#pragma once
#include <string>
#include <string_view>

#include "api/ask/vehicle/vehicle_check.h"

namespace slackwater::api {

/// The page of `slackwater vehicle check --html`: the verdict, the turning circle from above, the
/// zig-zags in time, and the tables.
/// @param beside_trial  `trial_text` and `fit_text`; empty: it was held against none
[[nodiscard]] std::string check_page_html(const VehicleCheck& check, std::string_view beside_trial,
                                          std::string_view plotting_library);

}  // namespace slackwater::api
