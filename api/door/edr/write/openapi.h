#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "api/issued/issued_fields.h"

namespace slackwater::api::edr {

/// The interface as an OpenAPI 3.0 document: every path that the service has, every parameter that
/// it takes, every answer that it gives.
[[nodiscard]] nlohmann::json openapi_document(const std::string& base,
                                              const ForecastCatalogue& catalogue);

}  // namespace slackwater::api::edr
