#pragma once
#include <nlohmann/json_fwd.hpp>

namespace slackwater::api::desk {

/// What the document of `/api` says of these routes: OpenAPI 3.0, to be merged into it (RFC 7396).
[[nodiscard]] nlohmann::json interface_document();

}  // namespace slackwater::api::desk
