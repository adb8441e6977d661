#include "api/door/edr/write/openapi.h"

#include <nlohmann/json.hpp>

#include "api/door/edr/read/feature_filter.h"
#include "api/door/edr/sample/product_collection.h"
#include "api/door/edr/sample/queries.h"
#include "api/door/edr/write/example_query.h"
#include "api/door/edr/write/openapi_parts.h"
#include "api/program/version.h"

namespace slackwater::api::edr {
namespace {

using nlohmann::json;

json parameter(const std::string& name) { return openapi_reference("parameters", name); }

json with(json list, const std::vector<std::string>& names) {
  for (const std::string& name : names) list.push_back(parameter(name));
  return list;
}

json operation(const std::string& id, const std::string& summary, const char* tag, json parameters,
               const std::string& answer) {
  return {{"get",
           {{"operationId", id},
            {"summary", summary},
            {"tags", json::array({tag})},
            {"parameters", std::move(parameters)},
            {"responses", openapi_responses_of(answer)}}}};
}

/// What a query needs; the example of coordinates is of the query's own shape.
json fitted(json needed, const std::string& name, std::string_view query, const Example& example) {
  needed["required"] = true;
  if (name == "coords") needed["example"] = example_coords(query, example);
  return needed;
}

/// @param of_forecasts  the path parameters of queries that stored products do not take
void add_queries(json& paths, const json& all, const Example& example, const std::string& at,
                 const json& fixed, const json& of_forecasts, const std::string& of,
                 const char* tag) {
  for (const QueryType& type : query_types()) {
    json list = is_for_products(type.name) ? fixed : of_forecasts;
    for (std::size_t i = 0; i < type.parameters.size(); ++i) {
      const std::string name(type.parameters[i]);
      // A collection without a vertical has no use for the z of a cube.
      const bool is_needed = i < type.needed && name != "z";
      list.push_back(is_needed ? fitted(all.at(name), name, type.name, example) : parameter(name));
    }
    paths[at + "/" + std::string(type.name)] =
        operation("get_" + of + std::string(type.name), std::string(type.description), tag,
                  std::move(list), "Data");
  }
  paths[at + "/locations"] = operation(
      "get_" + of + "locations", "Locations by name", tag,
      with(fixed, {"bbox", "datetime", "limit", "offset", "features-f"}), "FeatureCollection");
  json list = with(fixed, {"locationId"});
  for (const std::string_view name : location_parameters())
    list.push_back(parameter(std::string(name)));
  paths[at + "/locations/{locationId}"] =
      operation("get_" + of + "location", "Series and profiles at a location", tag, list, "Data");
}

json paths_of(const json& all, const Example& example) {
  const json none = json::array();
  const json collection = with(none, {"collectionId"});
  const json forecasts = with(none, {"forecastCollectionId"});
  const json instance = with(forecasts, {"instanceId"});
  const json f = with(none, {"document-f"});
  const char* capabilities = "Capabilities";
  const char* queries = "Collection data queries";
  const std::string at = "/collections/{collectionId}";
  json paths = {
      {"/", operation("get_landing_page", "Landing page", capabilities, f, "LandingPage")},
      {"/conformance",
       operation("get_conformance", "Conformance classes", capabilities, f, "Conformance")},
      {"/api", operation("get_api", "This document", capabilities, f, "Interface")},
      {"/collections",
       operation("get_collections", "Collections", "Collection metadata", f, "Collections")}};
  paths[at] = operation("get_collection", "A collection over the forecasts in force",
                        "Collection metadata", with(collection, {"document-f"}), "Collection");
  add_queries(paths, all, example, at, collection, forecasts, "", queries);
  paths[at + "/items"] = operation(
      "get_items", "Issued forecasts as features", queries,
      with(forecasts, {"bbox", "datetime", "limit", "offset", "features-f"}), "FeatureCollection");
  paths[at + "/items/{itemId}"] = operation("get_item", "An issued forecast as a feature", queries,
                                            with(forecasts, {"itemId", "features-f"}), "Feature");
  paths[at + "/instances"] =
      operation("get_instances", "Issued forecasts, newest first", "Instance metadata",
                with(forecasts, {"document-f"}), "Instances");
  paths[at + "/instances/{instanceId}"] =
      operation("get_instance", "One issued forecast", "Instance metadata",
                with(instance, {"document-f"}), "Collection");
  add_queries(paths, all, example, at + "/instances/{instanceId}", instance, instance, "instance_",
              "Instance data queries");
  return paths;
}

}  // namespace

json openapi_document(const std::string& base, const ForecastCatalogue& catalogue) {
  const Example example = example_of(catalogue);
  const json all = openapi_parameters(example, catalogue);
  json tags = json::array();
  for (const char* tag : {"Capabilities", "Collection metadata", "Instance metadata",
                          "Collection data queries", "Instance data queries"})
    tags.push_back({{"name", tag}});
  return {
      {"openapi", "3.0.3"},
      {"info",
       {{"title", "Slackwater"},
        {"description",
         "Forecasts of current, wind, waves and sea level for offshore sites, the products they "
         "were "
         "made from and what instruments measured, over OGC API-EDR 1.1. Nothing here writes, and "
         "nothing is "
         "access-controlled."},
        {"version", code_version()},
        {"license", {{"name", "See the repository"}}}}},
      {"servers", json::array({{{"url", base.empty() ? "/" : base}}})},
      {"tags", tags},
      {"paths", paths_of(all, example)},
      {"components",
       {{"parameters", all}, {"responses", openapi_responses()}, {"schemas", openapi_schemas()}}}};
}

}  // namespace slackwater::api::edr
