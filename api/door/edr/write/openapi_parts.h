#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "api/door/edr/write/example_query.h"

// The components of the OpenAPI document: openapi.cc makes paths of them.

namespace slackwater::api::edr {

/// {"$ref": "#/components/KIND/NAME"}
[[nodiscard]] nlohmann::json openapi_reference(const std::string& kind, const std::string& name);

/// Parameters by name, in path and query, with examples that can be tried as they stand.
[[nodiscard]] nlohmann::json openapi_parameters(const Example& example,
                                                const ForecastCatalogue& catalogue);

/// Schemas of all that is answered in JSON: what we promise of it.
[[nodiscard]] nlohmann::json openapi_schemas();

/// Responses by name; "Data", "Features", ... for 200 and one for each refusal, "400", "404", ...
[[nodiscard]] nlohmann::json openapi_responses();

/// The responses of an operation that succeeds with `answer`: that, and every refusal that a server
/// of ours may send to a GET.
[[nodiscard]] nlohmann::json openapi_responses_of(const std::string& answer);

}  // namespace slackwater::api::edr
