#pragma once
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <string>

// Words of an OpenAPI 3.0 document that the doors beside EDR share. Components that they refer to
// (parameters, responses by status, the schema Problem) are in the document that they are merged
// into.

namespace slackwater::api::http::openapi {

/// {"$ref": "#/components/KIND/NAME"}
[[nodiscard]] nlohmann::json reference(const std::string& kind, const std::string& name);
[[nodiscard]] nlohmann::json text();
[[nodiscard]] nlohmann::json whole();
[[nodiscard]] nlohmann::json list_of(nlohmann::json items);
[[nodiscard]] nlohmann::json object(nlohmann::json properties);
/// A response of JSON of that schema.
[[nodiscard]] nlohmann::json answer(const std::string& description, nlohmann::json schema);
/// A refusal, as RFC 7807 has it.
[[nodiscard]] nlohmann::json refused_for(const std::string& description);
/// An operation for who asks from this machine or shows the operator's token, others refused by
/// that status; the document has `operator_scheme` among its `securitySchemes`.
[[nodiscard]] nlohmann::json for_operators(nlohmann::json operation, const char* refused_by);
[[nodiscard]] nlohmann::json operator_scheme();
/// What any request may be refused for; and `more`, statuses that the document knows.
[[nodiscard]] nlohmann::json refusals(std::initializer_list<const char*> more = {});
[[nodiscard]] nlohmann::json operation(const std::string& id, const std::string& tag,
                                       const std::string& summary, nlohmann::json parameters,
                                       nlohmann::json responses);

}  // namespace slackwater::api::http::openapi
