#include "api/door/http/interface_words.h"

#include <nlohmann/json.hpp>

namespace slackwater::api::http::openapi {

using nlohmann::json;

json reference(const std::string& kind, const std::string& name) {
  return {{"$ref", "#/components/" + kind + "/" + name}};
}

json text() { return {{"type", "string"}}; }
json whole() { return {{"type", "integer"}}; }
json list_of(json items) { return {{"type", "array"}, {"items", std::move(items)}}; }
json object(json properties) { return {{"type", "object"}, {"properties", std::move(properties)}}; }

json answer(const std::string& description, json schema) {
  return {{"description", description},
          {"content", {{"application/json", {{"schema", std::move(schema)}}}}}};
}

json for_operators(json operation, const char* refused_by) {
  operation["responses"][refused_by] =
      refused_for("Neither from this machine nor with the token of --token-file");
  operation["security"] = json::array({json::object(), {{"operator", json::array()}}});
  return operation;
}

json operator_scheme() { return {{"operator", {{"type", "http"}, {"scheme", "bearer"}}}}; }

json refused_for(const std::string& description) {
  return {
      {"description", description},
      {"content", {{"application/problem+json", {{"schema", reference("schemas", "Problem")}}}}}};
}

json refusals(std::initializer_list<const char*> more) {
  json all = json::object();
  for (const char* status : {"400", "405", "408", "413", "414", "431", "500", "503"})
    all[status] = reference("responses", status);
  for (const char* status : more) all[status] = reference("responses", status);
  return all;
}

json operation(const std::string& id, const std::string& tag, const std::string& summary,
               json parameters, json responses) {
  return {{"operationId", id},
          {"summary", summary},
          {"tags", json::array({tag})},
          {"parameters", std::move(parameters)},
          {"responses", std::move(responses)}};
}

}  // namespace slackwater::api::http::openapi
