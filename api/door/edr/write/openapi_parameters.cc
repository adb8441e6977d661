#include <nlohmann/json.hpp>

#include "api/door/edr/read/crs.h"
#include "api/door/edr/read/distance.h"
#include "api/door/edr/read/feature_filter.h"
#include "api/door/edr/sample/collection.h"
#include "api/door/edr/write/body.h"
#include "api/door/edr/write/content.h"
#include "api/door/edr/write/openapi_parts.h"

namespace slackwater::api::edr {
namespace {

using nlohmann::json;

json query_parameter(const std::string& name, const std::string& description, json schema,
                     json example) {
  return {{"name", name},
          {"in", "query"},
          {"description", description},
          {"required", false},
          {"schema", std::move(schema)},
          {"example", std::move(example)},
          {"style", "form"},
          {"explode", false}};
}

json path_parameter(const std::string& name, const std::string& description, json schema,
                    const std::string& example) {
  return {{"name", name},
          {"in", "path"},
          {"description", description},
          {"required", true},
          {"schema", std::move(schema)},
          {"example", example}};
}

json text() { return {{"type", "string"}, {"minLength", 1}}; }

json one_of(const std::vector<std::string>& values) {
  return {{"type", "string"}, {"enum", values}};
}

json numbers(std::size_t count) {
  return {
      {"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", count}, {"maxItems", count}};
}

json number_text() { return {{"type", "string"}, {"pattern", "^[0-9]+(\\.[0-9]+)?$"}}; }
json count_text() { return {{"type", "string"}, {"pattern", "^[0-9]{1,3}$"}}; }

json distances() {
  std::vector<std::string> units;
  for (const std::string_view unit : distance_units()) units.emplace_back(unit);
  const json unit = one_of(units);
  return {
      {"within", query_parameter("within", "Radius", number_text(), "5")},
      {"within-units", query_parameter("within-units", "Unit of the radius", unit, "km")},
      {"corridor-width", query_parameter("corridor-width", "Whole width", number_text(), "1000")},
      {"width-units", query_parameter("width-units", "Unit of the width", unit, "m")},
      {"corridor-height", query_parameter("corridor-height", "Whole height", number_text(), "10")},
      {"height-units", query_parameter("height-units", "Unit of the height", unit, "m")},
      {"resolution-x",
       query_parameter("resolution-x",
                       "Positions along x; of a corridor, across its width. 0: as stored",
                       count_text(), "5")},
      {"resolution-y",
       query_parameter("resolution-y",
                       "Positions along y; of a corridor, along its path. 0: as stored",
                       count_text(), "5")},
      {"resolution-z",
       query_parameter("resolution-z", "Positions along z. 0: as stored", count_text(), "3")}};
}

json choices() {
  std::vector<std::string> formats;
  for (const Format format : answer_formats()) formats.emplace_back(name_of(format));
  std::vector<std::string> systems;
  for (const std::string_view name : crs_names()) systems.emplace_back(name);
  return {{"crs",
           query_parameter("crs", "WGS 84, longitude before latitude", one_of(systems), "CRS84")},
          {"f", query_parameter("f", "Format of the answer", one_of(formats), "CoverageJSON")},
          {"document-f",
           query_parameter("f", "Format of the answer", one_of({"JSON", "HTML"}), "JSON")},
          {"features-f", query_parameter("f", "Format of the answer",
                                         one_of({"GeoJSON", "JSON", "HTML"}), "GeoJSON")},
          {"limit", query_parameter("limit", "Features on a page; at most 10 000 are sent",
                                    {{"type", "integer"},
                                     {"minimum", 1},
                                     {"maximum", 999'999'999},
                                     {"default", usual_features}},
                                    100)},
          {"offset",
           query_parameter("offset", "Features before this page",
                           {{"type", "integer"}, {"minimum", 0}, {"maximum", 999'999'999}}, 0)}};
}

}  // namespace

json openapi_reference(const std::string& kind, const std::string& name) {
  return {{"$ref", "#/components/" + kind + "/" + name}};
}

json openapi_parameters(const Example& example, const ForecastCatalogue& catalogue) {
  const double x = example.longitude_deg;
  const double y = example.latitude_deg;
  std::vector<std::string> ids;
  for (const Collection& collection : collections()) ids.push_back(collection.id);
  const std::vector<std::string> of_forecasts = ids;
  for (const StoredProduct& product : *catalogue.products) ids.push_back(product.id);
  json all = {
      {"coords", query_parameter("coords", "Well Known Text, longitude before latitude", text(),
                                 example_coords("position", example))},
      {"bbox", query_parameter("bbox", "west,south,east,north in degrees",
                               {{"oneOf", json::array({numbers(4), numbers(6)})}},
                               json::array({x - 0.1, y - 0.1, x + 0.1, y + 0.1}))},
      {"z", query_parameter("z",
                            "Depth below (currents) or height above (wind) mean sea level, m: "
                            "10, 0,5,10, 0/50 or R5/0/10",
                            text(), json(example.depth_m).dump())},
      {"datetime",
       query_parameter("datetime", "An instant or an interval, RFC 3339: T, A/B, ../B, A/..",
                       text(), format_utc(example.time))},
      {"parameter-name",
       query_parameter(
           "parameter-name", "Names separated by commas; all where absent",
           {{"type", "array"}, {"items", {{"type", "string"}}}, {"minItems", 1}},
           json::array({"eastward_sea_water_velocity", "northward_sea_water_velocity"}))},
      {"collectionId",
       path_parameter("collectionId", "One of /collections", one_of(ids), "currents")},
      {"forecastCollectionId",
       path_parameter("collectionId", "One of /collections that is no stored product",
                      one_of(of_forecasts), "currents")},
      {"instanceId", path_parameter("instanceId", "One of the collection's /instances", text(),
                                    example.instance)},
      {"locationId",
       path_parameter("locationId", "One of the collection's /locations", text(), example.site)},
      {"itemId",
       path_parameter("itemId", "One of the collection's /items", text(), example.instance)}};
  all.update(distances());
  all.update(choices());
  return all;
}

}  // namespace slackwater::api::edr
