#include <array>
#include <nlohmann/json.hpp>

#include "api/door/edr/write/openapi_parts.h"

namespace slackwater::api::edr {
namespace {

using nlohmann::json;

json schema(const char* name) { return openapi_reference("schemas", name); }
json any_text() { return {{"type", "string"}}; }
json constant(const char* value) { return {{"type", "string"}, {"enum", json::array({value})}}; }
json array_of(json items) { return {{"type", "array"}, {"items", std::move(items)}}; }

json object(std::vector<std::string> required, json properties) {
  return {
      {"type", "object"}, {"required", std::move(required)}, {"properties", std::move(properties)}};
}

json described_collection() {
  return object(
      {"id", "title", "description", "links", "extent", "data_queries", "crs", "output_formats",
       "parameter_names"},
      {{"id", any_text()},
       {"title", any_text()},
       {"description", any_text()},
       {"keywords", array_of(any_text())},
       {"links", array_of(schema("Link"))},
       {"extent", object({"spatial"}, {{"spatial", object({"bbox", "crs"}, json::object())}})},
       {"data_queries", {{"type", "object"}, {"minProperties", 1}}},
       {"crs", array_of(any_text())},
       {"output_formats", array_of(any_text())},
       {"parameter_names",
        {{"type", "object"},
         {"additionalProperties",
          object({"type", "observedProperty", "unit"}, {{"type", constant("Parameter")}})}}}});
}

json feature() {
  return object({"type", "geometry", "properties"},
                {{"type", constant("Feature")},
                 {"geometry", {{"type", "object"}}},
                 {"properties", object({"datetime", "parameter-name", "label", "edrqueryendpoint"},
                                       {{"datetime", any_text()},
                                        {"parameter-name", array_of(any_text())},
                                        {"label", any_text()},
                                        {"edrqueryendpoint", any_text()}})}});
}

json response(const std::string& description,
              const std::vector<std::pair<std::string, json>>& media) {
  json content = json::object();
  for (const auto& [type, described] : media) content[type] = {{"schema", described}};
  return {{"description", description}, {"content", content}};
}

struct Refusal {
  const char* status;
  const char* description;
};
constexpr std::array refusals{
    Refusal{"400", "The request cannot be read; the detail says what was expected"},
    Refusal{"404", "Nothing there; the detail gives the valid range or names"},
    Refusal{"405", "A method that is not served"},
    Refusal{"408", "The request was not complete in time"},
    Refusal{"413", "The body is too large"},
    Refusal{"414", "The address is too long"},
    Refusal{"431", "The header is too large"},
    Refusal{"500", "The service failed; its log says why"},
    Refusal{"503", "The service cannot answer now, or not in time"}};

}  // namespace

json openapi_schemas() {
  const json links = array_of(schema("Link"));
  return {
      {"Link",
       object({"href", "rel"}, {{"href", any_text()}, {"rel", any_text()}, {"type", any_text()}})},
      {"LandingPage",
       object({"title", "description", "links"},
              {{"title", any_text()}, {"description", any_text()}, {"links", links}})},
      {"Conformance", object({"conformsTo"}, {{"conformsTo", array_of(any_text())}})},
      {"Interface", object({"openapi", "info", "paths"}, {{"openapi", constant("3.0.3")}})},
      {"Collection", described_collection()},
      {"Collections", object({"links", "collections"},
                             {{"links", links}, {"collections", array_of(schema("Collection"))}})},
      {"Instances", object({"links", "instances"},
                           {{"links", links}, {"instances", array_of(schema("Collection"))}})},
      {"Feature", feature()},
      {"FeatureCollection", object({"type", "features", "numberReturned", "links"},
                                   {{"type", constant("FeatureCollection")},
                                    {"features", array_of(schema("Feature"))},
                                    {"links", links}})},
      {"CoverageJson",
       object({"type", "parameters", "slackwater:provenance"},
              {{"type", {{"type", "string"}, {"enum", {"Coverage", "CoverageCollection"}}}},
               {"parameters", {{"type", "object"}}}})},
      {"Problem", object({"type", "title", "status", "detail"}, {{"type", any_text()},
                                                                 {"title", any_text()},
                                                                 {"status", {{"type", "integer"}}},
                                                                 {"detail", any_text()},
                                                                 {"instance", any_text()}})}};
}

json openapi_responses() {
  const auto document = [](const char* name, const char* description) {
    return response(description, {{"application/json", schema(name)}, {"text/html", any_text()}});
  };
  const auto features = [](const char* name, const char* description) {
    return response(description, {{"application/geo+json", schema(name)},
                                  {"application/json", schema(name)},
                                  {"text/html", any_text()}});
  };
  json all = {
      {"LandingPage", document("LandingPage", "Where to go from here")},
      {"Conformance", document("Conformance", "What the service conforms to")},
      {"Collections", document("Collections", "All collections")},
      {"Collection", document("Collection", "A collection, or an instance of one")},
      {"Instances", document("Instances", "Issued forecasts, newest first")},
      {"FeatureCollection", features("FeatureCollection", "Features")},
      {"Feature", features("Feature", "A feature")},
      {"Interface", response("This document",
                             {{"application/vnd.oai.openapi+json;version=3.0", schema("Interface")},
                              {"application/json", schema("Interface")},
                              {"text/html", any_text()}})},
      {"Data", response("The values, with their provenance",
                        {{"application/prs.coverage+json", schema("CoverageJson")},
                         {"application/json", schema("CoverageJson")},
                         {"application/geo+json", schema("FeatureCollection")},
                         {"text/csv", any_text()},
                         {"application/netcdf", {{"type", "string"}, {"format", "binary"}}}})},
      {"NotModified", {{"description", "The client has it already (If-None-Match)"}}}};
  for (const Refusal& refusal : refusals) {
    all[refusal.status] =
        response(refusal.description, {{"application/problem+json", schema("Problem")}});
  }
  return all;
}

json openapi_responses_of(const std::string& answer) {
  json all = {{"200", openapi_reference("responses", answer)},
              {"304", openapi_reference("responses", "NotModified")}};
  for (const Refusal& refusal : refusals)
    all[refusal.status] = openapi_reference("responses", refusal.status);
  return all;
}

}  // namespace slackwater::api::edr
