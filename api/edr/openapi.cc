#include "api/edr/openapi.h"

#include <nlohmann/json.hpp>

#include "api/edr/body.h"
#include "api/edr/collection.h"
#include "api/edr/content.h"
#include "api/edr/distance.h"
#include "api/edr/queries.h"
#include "api/edr/resolution.h"
#include "api/pipeline/version.h"

namespace slackwater::api::edr {
namespace {

using nlohmann::json;

json reference(const std::string& kind, const std::string& name) {
  return {{"$ref", "#/components/" + kind + "/" + name}};
}

json query_parameter(const char* name, const char* description, json schema, const char* example) {
  return {{"name", name},
          {"in", "query"},
          {"description", description},
          {"required", false},
          {"schema", std::move(schema)},
          {"example", example},
          {"style", "form"},
          {"explode", false}};
}

json path_parameter(const char* name, const char* description) {
  return {{"name", name},
          {"in", "path"},
          {"description", description},
          {"required", true},
          {"schema", {{"type", "string"}, {"minLength", 1}}}};
}

json text() { return {{"type", "string"}, {"minLength", 1}}; }

json parameters() {
  json formats = json::array();
  for (const Format format : answer_formats()) formats.push_back(name_of(format));
  json units = json::array();
  for (const std::string_view unit : distance_units()) units.push_back(unit);
  const json count = {{"type", "integer"}, {"minimum", 0}, {"maximum", max_resolution}};
  const json number = {{"type", "string"}, {"pattern", "^[0-9]+(\\.[0-9]+)?$"}};
  return {
      {"coords", query_parameter("coords", "Well Known Text, longitude before latitude", text(),
                                 "POINT(-2.55 48.85)")},
      {"bbox",
       query_parameter("bbox", "west,south,east,north in degrees", text(), "-2.7,48.7,-2.4,49.0")},
      {"z", query_parameter("z",
                            "Depth below (currents) or height above (wind) mean sea level, m: "
                            "10, 0,5,10, 0/50 or R5/0/10",
                            text(), "0/20")},
      {"datetime",
       query_parameter("datetime", "An instant or an interval, RFC 3339: T, A/B, ../B, A/..",
                       text(), "2025-03-10T06:00:00Z")},
      {"parameter-name",
       query_parameter("parameter-name", "Names separated by commas; all where absent", text(),
                       "eastward_sea_water_velocity,northward_sea_water_velocity")},
      {"crs", query_parameter("crs", "CRS84 (longitude, latitude)",
                              {{"type", "string"}, {"enum", {"CRS84", "EPSG:4326", "OGC:CRS84"}}},
                              "CRS84")},
      {"f", query_parameter("f", "Format of the answer", {{"type", "string"}, {"enum", formats}},
                            "CoverageJSON")},
      {"within", query_parameter("within", "Radius", number, "5")},
      {"within-units", query_parameter("within-units", "Unit of the radius",
                                       {{"type", "string"}, {"enum", units}}, "km")},
      {"corridor-width", query_parameter("corridor-width", "Whole width", number, "1000")},
      {"width-units", query_parameter("width-units", "Unit of the width",
                                      {{"type", "string"}, {"enum", units}}, "m")},
      {"corridor-height", query_parameter("corridor-height", "Whole height", number, "10")},
      {"height-units", query_parameter("height-units", "Unit of the height",
                                       {{"type", "string"}, {"enum", units}}, "m")},
      {"resolution-x", query_parameter("resolution-x", "Positions along x", count, "5")},
      {"resolution-y", query_parameter("resolution-y", "Positions along y", count, "5")},
      {"resolution-z", query_parameter("resolution-z", "Positions along z", count, "3")},
      {"metadata-f", query_parameter("f", "Format of the answer",
                                     {{"type", "string"}, {"enum", {"json", "JSON"}}}, "json")},
      {"collectionId", path_parameter("collectionId", "One of /collections")},
      {"instanceId", path_parameter("instanceId", "One of the collection's /instances")},
      {"locationId", path_parameter("locationId", "One of the collection's /locations")},
      {"itemId", path_parameter("itemId", "One of the collection's /items")}};
}

json response(const std::string& description, const json& media) {
  json content = json::object();
  for (const auto& type : media) content[type.get<std::string>()] = {{"schema", json::object()}};
  return {{"description", description}, {"content", content}};
}

json responses() {
  const json problem = json::array({"application/problem+json"});
  const auto refusal = [&](const char* description) {
    json r = response(description, problem);
    r["content"]["application/problem+json"]["schema"] = reference("schemas", "Problem");
    return r;
  };
  return {{"Document", response("A JSON document", json::array({"application/json"}))},
          {"Features", response("GeoJSON features", json::array({"application/geo+json"}))},
          {"Api", response("This document",
                           json::array({"application/vnd.oai.openapi+json;version=3.0"}))},
          {"Data", response("The values, with their provenance",
                            json::array({"application/prs.coverage+json", "application/geo+json",
                                         "text/csv", "application/netcdf"}))},
          {"Text", response("Text", json::array({"text/plain"}))},
          {"BadRequest", refusal("The request cannot be read; the detail says what was expected")},
          {"NotFound", refusal("Nothing there; the detail gives the valid range or names")},
          {"Unavailable", refusal("The service cannot answer now")}};
}

json operation(const std::string& id, const std::string& summary, const char* tag, json parameters,
               const char* answer) {
  return {{"get",
           {{"operationId", id},
            {"summary", summary},
            {"tags", json::array({tag})},
            {"parameters", std::move(parameters)},
            {"responses",
             {{"200", reference("responses", answer)},
              {"400", reference("responses", "BadRequest")},
              {"404", reference("responses", "NotFound")},
              {"503", reference("responses", "Unavailable")}}}}}};
}

json needed(json parameter_reference, const json& all, const std::string& name) {
  parameter_reference = all.at(name);
  parameter_reference["required"] = true;
  return parameter_reference;
}

void add_queries(json& paths, const json& all, const std::string& at, const json& fixed,
                 const std::string& of, const char* tag) {
  for (const QueryType& type : query_types()) {
    json list = fixed;
    for (std::size_t i = 0; i < type.parameters.size(); ++i) {
      const std::string name(type.parameters[i]);
      list.push_back(i < type.needed ? needed({}, all, name) : reference("parameters", name));
    }
    paths[at + "/" + std::string(type.name)] =
        operation("get_" + of + std::string(type.name), std::string(type.description), tag,
                  std::move(list), "Data");
  }
  json list = fixed;
  list.push_back(reference("parameters", "metadata-f"));
  paths[at + "/locations"] =
      operation("get_" + of + "locations", "Locations by name", tag, list, "Features");
  list = fixed;
  list.push_back(reference("parameters", "locationId"));
  for (const std::string_view name : location_parameters())
    list.push_back(reference("parameters", std::string(name)));
  paths[at + "/locations/{locationId}"] =
      operation("get_" + of + "location", "Series and profiles at a location", tag, list, "Data");
}

}  // namespace

json openapi_document(const std::string& base) {
  const json all = parameters();
  const json collection = json::array({reference("parameters", "collectionId")});
  const json instance =
      json::array({reference("parameters", "collectionId"), reference("parameters", "instanceId")});
  const json f = json::array({reference("parameters", "metadata-f")});
  const auto with_f = [](json list) {
    list.push_back(reference("parameters", "metadata-f"));
    return list;
  };
  json paths;
  paths["/"] = operation("get_landing_page", "Landing page", "Capabilities", f, "Document");
  paths["/conformance"] =
      operation("get_conformance", "Conformance classes", "Capabilities", f, "Document");
  paths["/api"] = operation("get_api", "This document", "Capabilities", json::array(), "Api");
  paths["/health"] =
      operation("get_health", "Whether the service is well", "Service", json::array(), "Document");
  paths["/metrics"] =
      operation("get_metrics", "Counters for Prometheus", "Service", json::array(), "Text");
  paths["/collections"] =
      operation("get_collections", "Collections", "Collection metadata", f, "Document");
  const std::string at = "/collections/{collectionId}";
  paths[at] = operation("get_collection", "A collection over the forecasts in force",
                        "Collection metadata", with_f(collection), "Document");
  add_queries(paths, all, at, collection, "", "Collection data queries");
  paths[at + "/items"] = operation("get_items", "Issued forecasts as features",
                                   "Collection data queries", with_f(collection), "Features");
  json item = collection;
  item.push_back(reference("parameters", "itemId"));
  paths[at + "/items/{itemId}"] = operation("get_item", "An issued forecast as a feature",
                                            "Collection data queries", with_f(item), "Features");
  paths[at + "/instances"] = operation("get_instances", "Issued forecasts, newest first",
                                       "Instance metadata", with_f(collection), "Document");
  paths[at + "/instances/{instanceId}"] = operation(
      "get_instance", "One issued forecast", "Instance metadata", with_f(instance), "Document");
  add_queries(paths, all, at + "/instances/{instanceId}", instance, "instance_",
              "Instance data queries");
  return {{"openapi", "3.0.3"},
          {"info",
           {{"title", "Slackwater"},
            {"description",
             "Forecasts of current, wind and waves for offshore sites over OGC API-EDR 1.1"},
            {"version", code_version()},
            {"license", {{"name", "See the repository"}}}}},
          {"servers", json::array({{{"url", base}}})},
          {"tags", json::array({{{"name", "Capabilities"}},
                                {{"name", "Collection metadata"}},
                                {{"name", "Instance metadata"}},
                                {{"name", "Collection data queries"}},
                                {{"name", "Instance data queries"}},
                                {{"name", "Service"}}})},
          {"paths", paths},
          {"components",
           {{"parameters", all},
            {"responses", responses()},
            {"schemas",
             {{"Problem",
               {{"type", "object"},
                {"required", json::array({"title", "status"})},
                {"properties",
                 {{"type", {{"type", "string"}}},
                  {"title", {{"type", "string"}}},
                  {"status", {{"type", "integer"}}},
                  {"detail", {{"type", "string"}}},
                  {"instance", {{"type", "string"}}}}}}}}}}}};
}

}  // namespace slackwater::api::edr
