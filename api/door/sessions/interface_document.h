#pragma once
#include <nlohmann/json_fwd.hpp>

namespace slackwater::sessions {

/// The paths of sessions for an OpenAPI 3.0 document, to be merged into that of the forecasts
/// (`edr::add_routes`), whose descriptions of refusals they refer to.
[[nodiscard]] nlohmann::json interface_document();

}  // namespace slackwater::sessions
