#include "api/door/edr/write/metadata.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "api/door/edr/read/crs.h"
#include "api/door/edr/read/distance.h"
#include "api/door/edr/sample/queries.h"
#include "api/door/edr/write/body.h"
#include "api/door/edr/write/content.h"
#include "api/door/edr/write/example_query.h"
#include "api/program/version.h"
#include "fields/base/encode/percent.h"

namespace slackwater::api::edr {
namespace {

using nlohmann::json;

constexpr const char* crs84_wkt =
    R"wkt(GEOGCRS["WGS 84 (CRS84)",DATUM["World Geodetic System 1984",)wkt"
    R"wkt(ELLIPSOID["WGS 84",6378137,298.257223563]],CS[ellipsoidal,2],)wkt"
    R"wkt(AXIS["geodetic longitude (Lon)",east],AXIS["geodetic latitude (Lat)",north],)wkt"
    R"wkt(UNIT["degree",0.0174532925199433],ID["OGC","CRS84"]])wkt";
constexpr const char* depth_wkt =
    R"wkt(VERTCRS["depth below mean sea level",VDATUM["mean sea level"],CS[vertical,1],)wkt"
    R"wkt(AXIS["depth (D)",down],LENGTHUNIT["metre",1]])wkt";
constexpr const char* height_wkt =
    R"wkt(VERTCRS["height above mean sea level",VDATUM["mean sea level"],CS[vertical,1],)wkt"
    R"wkt(AXIS["height (H)",up],LENGTHUNIT["metre",1]])wkt";
constexpr const char* gregorian =
    R"wkt(TIMECRS["UTC",TDATUM["Gregorian calendar"],CS[TemporalDateTime,1],)wkt"
    R"wkt(AXIS["time (T)",future]])wkt";

json link(const std::string& href, const char* rel, const char* type, const std::string& title) {
  return {{"href", href}, {"rel", rel}, {"type", type}, {"title", title}, {"hreflang", "en"}};
}

json formats() {
  json names = json::array();
  for (const Format format : answer_formats()) names.push_back(name_of(format));
  return names;
}

std::string shortest(double value) { return json(value).dump(); }

json parameter_names(const std::vector<Parameter>& parameters) {
  json names = json::object();
  for (const Parameter& p : parameters) {
    names[p.name] = {
        {"type", "Parameter"},
        {"id", p.name},
        {"description", p.description},
        {"label", p.label},
        {"data-type", "float"},
        {"unit",
         {{"label", {{"en", p.unit_label}}},
          {"symbol", {{"value", p.unit}, {"type", "http://www.opengis.net/def/uom/UCUM/"}}}}},
        {"observedProperty",
         {{"id", "http://vocab.nerc.ac.uk/standard_name/" + p.standard_name + "/"},
          {"label", {{"en", p.label}}}}},
        {"measurementType", {{"method", p.method}}}};
  }
  return names;
}

/// What a document says of each query: all, or, where hundreds of instances
/// are listed, what it must.
enum class Detail { whole, brief };

json query_link(const std::string& at, std::string_view name, std::string_view title,
                std::string_view description, Detail detail) {
  json variables = {{"title", title},
                    {"query_type", name},
                    {"output_formats", formats()},
                    {"default_output_format", "CoverageJSON"}};
  if (detail == Detail::whole) {
    variables["description"] = description;
    variables["crs_details"] = json::array({{{"crs", "CRS84"}, {"wkt", crs84_wkt}}});
  }
  json units = json::array();
  for (const std::string_view unit : distance_units()) units.push_back(unit);
  if (name == "radius") variables["within_units"] = units;
  if (name == "corridor") {
    variables["width_units"] = units;
    variables["height_units"] = units;
  }
  if (name == "cube") variables["height_units"] = json::array({"m"});
  return {{"link",
           {{"href", at + "/" + std::string(name)},
            {"rel", "data"},
            {"title", title},
            {"templated", false},
            {"variables", variables}}}};
}

using Fields = std::vector<std::shared_ptr<const Field>>;

/// @param answering  the fields of which one answers: then each query has an example that works
json data_queries(const std::string& at, const Collection& collection, const Fields& answering,
                  Detail detail) {
  json queries = json::object();
  std::optional<Example> example;
  for (std::size_t i = 0; i < answering.size() && !example && detail == Detail::whole; ++i)
    example = example_of(collection, *answering[i]);
  for (const QueryType& type : query_types()) {
    const std::string name(type.name);
    queries[name] = query_link(at, name, type.title, type.description, detail);
    if (example) {
      queries[name]["link"]["slackwater:example"] =
          at + "/" + name + "?" + example_query(type, collection, *example);
    }
  }
  queries["locations"] =
      query_link(at, "locations", "Locations", "The columns of each site by name", detail);
  return queries;
}

/// Items are the instances as features: of a collection alone.
json items_query(const std::string& at) {
  json query = query_link(at, "items", "Items", "Issued forecasts as features", Detail::whole);
  json& variables = query["link"]["variables"];
  variables["output_formats"] = json::array({"GeoJSON", "JSON", "HTML"});
  variables["default_output_format"] = "GeoJSON";
  return query;
}

/// A link to a document and to its rendition for people.
json self_links(const std::string& href, const std::string& title) {
  return json::array({link(href, "self", "application/json", title),
                      link(href + "?f=html", "alternate", "text/html", title)});
}

json described(const std::string& at, const Collection& collection, std::size_t members,
               const Fields& fields, const Fields& answering, Detail detail) {
  json links = self_links(at, collection.title);
  links.push_back(link(at + "/position", "data", "application/prs.coverage+json", "Position"));
  links.push_back(link(at + "/locations", "data", "application/geo+json", "Locations"));
  return {{"id", collection.id},
          {"title", collection.title},
          {"description", collection.description},
          {"keywords", collection.keywords},
          {"links", links},
          {"extent", extent_of(collection, fields)},
          {"data_queries", data_queries(at, collection, answering, detail)},
          {"crs", crs_names()},
          {"output_formats", formats()},
          {"parameter_names", parameter_names(parameters_of(collection, members))}};
}

std::vector<std::shared_ptr<const Field>> fields_of(const ForecastCatalogue& catalogue) {
  std::vector<std::shared_ptr<const Field>> fields;
  for (const auto& site : catalogue.sites) fields.push_back(site.field);
  return fields;
}

std::size_t most_members(const std::vector<std::shared_ptr<const Field>>& fields) {
  std::size_t members = 1;
  for (const auto& field : fields) members = std::max(members, field->snapshot().members);
  return members;
}

json temporal_extent(UtcTime from, UtcTime to) {
  return {{"interval", json::array({json::array({format_utc(from), format_utc(to)})})},
          {"trs", gregorian}};
}

/// The stamps of forecasts, each once. (As ranges or repetitions they would be shorter, and the
/// standard's text allows that; its schema wants a date-time each.)
json stamps_of(const std::vector<std::shared_ptr<const Field>>& fields) {
  std::set<UtcTime> stamps;
  for (const auto& field : fields) {
    const std::vector<UtcTime>& time = field->snapshot().time;
    stamps.insert(time.begin(), time.end());
  }
  json values = json::array();
  for (const UtcTime stamp : stamps) values.push_back(format_utc(stamp));
  return values;
}

std::string place_of(const std::string& base, const Collection& collection) {
  return base + "/collections/" + collection.id;
}

}  // namespace

namespace {

/// A site as the landing page lists it: how its forecast stands, and where its values are.
json described_site(const std::string& base, const SiteState& state,
                    const ForecastCatalogue& catalogue, const Freshness& freshness) {
  json links = json::array();
  for (const auto& site : catalogue.sites) {
    if (site.site_id != state.site_id) continue;
    for (const Collection& collection : collections()) {
      if (collection.is_of_members || !example_of(collection, *site.field)) continue;
      links.push_back(link(
          place_of(base, collection) + "/locations/" + percent_encoded(state.site_id) + "?f=csv",
          "data", "text/csv", collection.title + " as CSV"));
    }
  }
  links.push_back(link(place_of(base, collections().front()) + "/instances/" +
                           percent_encoded(state.forecast.instance),
                       "item", "application/json", "This forecast"));
  const store::ForecastRow& row = state.forecast.row;
  return {{"id", state.site_id},
          {"title", state.site_name},
          {"status", name_of(state.condition)},
          {"description", in_words(state, freshness)},
          {"forecast", state.forecast.instance},
          {"issued", format_utc(row.issued)},
          {"age_s", std::chrono::duration_cast<std::chrono::seconds>(state.age).count()},
          {"day", format_day(row.day)},
          {"valid_to", format_utc(row.valid_to)},
          {"degraded", row.degraded},
          {"headline", row.headline},
          {"links", links}};
}

}  // namespace

json landing_page(const std::string& base, const ForecastCatalogue& catalogue,
                  const Freshness& freshness) {
  json sites = json::array();
  for (const SiteState& state : site_states(catalogue, freshness))
    sites.push_back(described_site(base, state, catalogue, freshness));
  return {{"title", "Slackwater"},
          {"description",
           "Calibrated, depth-resolved forecasts of current, wind and waves for offshore sites, as "
           "issued"},
          {"keywords", {"current", "wind", "waves", "forecast", "offshore wind"}},
          {"slackwater:sites", sites},
          {"links",
           {link(base + "/", "self", "application/json", "This page"),
            link(base + "/?f=html", "alternate", "text/html", "This page"),
            link(base + "/collections", "data", "application/json", "Collections"),
            link(base + "/api", "service-desc", "application/vnd.oai.openapi+json;version=3.0",
                 "The interface as OpenAPI 3.0"),
            link(base + "/api?f=html", "service-doc", "text/html", "The interface for people"),
            link(base + "/conformance", "conformance", "application/json",
                 "Conformance classes of OGC API-EDR 1.1")}},
          {"version", code_version()}};
}

json conformance() {
  const std::string edr = "http://www.opengis.net/spec/ogcapi-edr-1/1.1/conf/";
  json classes = json::array({"http://www.opengis.net/spec/ogcapi-common-1/1.0/conf/core",
                              "http://www.opengis.net/spec/ogcapi-common-2/1.0/conf/collections"});
  for (const char* name : {"core", "collections", "json", "geojson", "edr-geojson", "covjson",
                           "oas30", "queries", "instances"})
    classes.push_back(edr + name);
  // 1.1 asks for all that 1.0 did; clients and the executable test suite of 1.0 look for its names.
  for (const char* name : {"core", "geojson"})
    classes.push_back(std::string("http://www.opengis.net/spec/ogcapi-edr-1/1.0/conf/") + name);
  return {{"conformsTo", classes}};
}

json extent_of(const Collection& collection,
               const std::vector<std::shared_ptr<const Field>>& fields) {
  json extent = {{"spatial",
                  {{"bbox", json::array({json::array({-180, -90, 180, 90})})},
                   {"crs", std::string(crs84_uri)}}}};
  if (fields.empty()) return extent;
  slackwater::BoundingBox box = fields.front()->range().box;
  UtcTime from = fields.front()->range().from;
  UtcTime to = fields.front()->range().to;
  auto [low, high] = vertical_range(collection, *fields.front());
  std::vector<double> levels = all_levels(collection, *fields.front());
  for (const auto& field : fields) {
    const ValidRange& range = field->range();
    const bool is_cut = box.west_deg > box.east_deg || range.box.west_deg > range.box.east_deg;
    box.west_deg = is_cut && fields.size() > 1 ? -180 : std::min(box.west_deg, range.box.west_deg);
    box.east_deg = is_cut && fields.size() > 1 ? 180 : std::max(box.east_deg, range.box.east_deg);
    box.south_deg = std::min(box.south_deg, range.box.south_deg);
    box.north_deg = std::max(box.north_deg, range.box.north_deg);
    from = std::min(from, range.from);
    to = std::max(to, range.to);
    high = std::max(high, vertical_range(collection, *field).second);
    for (const double level : all_levels(collection, *field)) levels.push_back(level);
  }
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  extent["spatial"]["bbox"] =
      json::array({json::array({box.west_deg, box.south_deg, box.east_deg, box.north_deg})});
  extent["temporal"] = temporal_extent(from, to);
  extent["temporal"]["values"] = stamps_of(fields);
  if (collection.vertical != Vertical::none) {
    json values = json::array();
    for (const double level : levels) values.push_back(shortest(level));
    extent["vertical"] = {
        {"interval", json::array({json::array({shortest(low), shortest(high)})})},
        {"values", values},
        {"vrs", collection.vertical == Vertical::depth_down ? depth_wkt : height_wkt}};
  }
  return extent;
}

json collection_document(const std::string& base, const Collection& collection,
                         const ForecastCatalogue& catalogue) {
  const auto fields = fields_of(catalogue);
  const std::string at = place_of(base, collection);
  json document = described(at, collection, most_members(fields), fields, fields, Detail::whole);
  document["data_queries"]["items"] = items_query(at);
  document["links"].push_back(link(at + "/items", "items", "application/geo+json", "Items"));
  document["links"].push_back(
      link(at + "/instances", "instance", "application/json", "Issued forecasts"));
  return document;
}

namespace {

json extent_of(const StoredProduct& product) {
  const slackwater::BoundingBox& box = product.bounds;
  json extent = {
      {"spatial",
       {{"bbox",
         json::array({json::array({box.west_deg, box.south_deg, box.east_deg, box.north_deg})})},
        {"crs", std::string(crs84_uri)}}},
      {"temporal", temporal_extent(product.from, product.to)}};
  const Vertical vertical = vertical_of(product);
  if (vertical != Vertical::none && product.lowest_level_m && product.highest_level_m) {
    // The levels between stand in the files, which a list must not open.
    extent["vertical"] = {
        {"interval", json::array({json::array({shortest(*product.lowest_level_m),
                                               shortest(*product.highest_level_m)})})},
        {"vrs", vertical == Vertical::depth_down ? depth_wkt : height_wkt}};
  }
  return extent;
}

/// Where and when a product can be asked as it stands: about the first site that it covers, else
/// its middle, which may be land; at its last time.
struct ProductExample {
  Example at;
  bool is_at_a_site = false;
};

ProductExample example_of(const StoredProduct& product, const ForecastCatalogue& catalogue) {
  const slackwater::BoundingBox& box = product.bounds;
  const double east = box.east_deg < box.west_deg ? box.east_deg + 360 : box.east_deg;
  ProductExample example;
  example.at.longitude_deg = 0.5 * (box.west_deg + east);
  example.at.latitude_deg = 0.5 * (box.south_deg + box.north_deg);
  example.at.time = product.to;
  example.is_at_a_site = product.is_measured();
  for (const auto& site : catalogue.sites) {
    const GeoPoint& point = site.field->snapshot().columns.front().point;
    if (product.is_measured() || !box.contains(point)) continue;
    example.at.longitude_deg = point.longitude_deg();
    example.at.latitude_deg = point.latitude_deg();
    example.is_at_a_site = true;
    break;
  }
  return example;
}

json product_queries(const std::string& at, const StoredProduct& product,
                     const ForecastCatalogue& catalogue) {
  json queries = json::object();
  const ProductExample example = example_of(product, catalogue);
  const std::string z =
      product.lowest_level_m ? "&z=" + shortest(*product.lowest_level_m) : std::string();
  for (const QueryType& type : query_types()) {
    if (!is_for_products(type.name)) continue;
    const std::string name(type.name);
    const std::string what = product.is_measured() ? "What was measured, at its own place"
                             : name == "position" ? "The product at a point or several (MULTIPOINT)"
                             : name == "radius" ? "The product's cells within a distance of a point"
                             : name == "area"
                                 ? "The product's cells within a POLYGON or MULTIPOLYGON"
                                 : "The product's cells within a box of longitude, latitude and "
                                   "levels";
    queries[name] = query_link(at, name, type.title, what, Detail::whole);
    if (name == "position" && !example.is_at_a_site) continue;
    std::string asked;
    for (std::size_t i = 0; i < type.needed; ++i) {
      if (type.parameters[i] == "z") continue;
      asked += (asked.empty() ? "" : "&") + std::string(type.parameters[i]) + "=" +
               percent_encoded(example_value(type.parameters[i], name, example.at));
    }
    queries[name]["link"]["slackwater:example"] = at + "/" + name + "?" + asked + z + "&datetime=" +
                                                  percent_encoded(format_utc(example.at.time));
  }
  queries["locations"] =
      query_link(at, "locations", "Locations",
                 product.is_measured() ? "What was measured, by the platform's name"
                                       : "The product at the columns of each site by name",
                 Detail::whole);
  return queries;
}

}  // namespace

json product_document(const std::string& base, const StoredProduct& product,
                      const ForecastCatalogue& catalogue) {
  const std::string at = base + "/collections/" + product.id;
  const std::string title = title_of(product);
  json links = self_links(at, title);
  links.push_back(link(at + "/position", "data", "application/prs.coverage+json", "Position"));
  links.push_back(link(at + "/locations", "data", "application/geo+json", "Locations"));
  links.push_back(link(base + "/collections/" + std::string(name_of(product.kind)), "related",
                       "application/json", "Our forecasts of the same"));
  return {{"id", product.id},
          {"title", title},
          {"description", description_of(product)},
          {"keywords",
           {product.is_measured() ? "measured" : "product", name_of(product.kind),
            product.is_measured() ? product.station : product.product_id}},
          {"links", links},
          {"extent", extent_of(product)},
          {"data_queries", product_queries(at, product, catalogue)},
          {"crs", crs_names()},
          {"output_formats", formats()},
          {"parameter_names", parameter_names(parameters_of(product))}};
}

json collections_document(const std::string& base, const ForecastCatalogue& catalogue) {
  json list = json::array();
  for (const Collection& collection : collections())
    list.push_back(collection_document(base, collection, catalogue));
  for (const StoredProduct& product : *catalogue.products)
    list.push_back(product_document(base, product, catalogue));
  return {{"links", self_links(base + "/collections", "Collections")}, {"collections", list}};
}

namespace {

/// An instance. Its columns are those of the site's forecast in force: a list must not open
/// hundreds of files, and an instance by name says of itself what the list says of it.
json described_instance(const std::string& base, const Collection& collection,
                        const ForecastCatalogue& catalogue, const IssuedForecast& forecast,
                        Detail detail) {
  std::vector<std::shared_ptr<const Field>> of_site;
  Fields own;
  for (const auto& site : catalogue.sites) {
    if (site.site_id == forecast.row.site_id) of_site.push_back(site.field);
    if (site.instance == forecast.instance) own.push_back(site.field);
  }
  const std::string at = place_of(base, collection) + "/instances/" + forecast.instance;
  json document = described(at, collection, most_members(of_site), of_site, own, detail);
  document["id"] = forecast.instance;
  document["title"] = collection.title + ", " + forecast.row.site_id + ", issued " +
                      format_utc(forecast.row.issued);
  document["description"] = forecast.row.headline;
  document["extent"]["temporal"] = temporal_extent(forecast.row.valid_from, forecast.row.valid_to);
  document["links"].push_back(link(place_of(base, collection), "collection", "application/json",
                                   collection.title + ", forecasts in force"));
  return document;
}

}  // namespace

json instance_document(const std::string& base, const Collection& collection,
                       const ForecastCatalogue& catalogue, const IssuedForecast& forecast) {
  return described_instance(base, collection, catalogue, forecast, Detail::whole);
}

json instances_document(const std::string& base, const Collection& collection,
                        const ForecastCatalogue& catalogue) {
  json list = json::array();
  for (const IssuedForecast& forecast : catalogue.instances)
    list.push_back(described_instance(base, collection, catalogue, forecast, Detail::brief));
  return {{"links", self_links(place_of(base, collection) + "/instances", "Issued forecasts")},
          {"instances", list}};
}

}  // namespace slackwater::api::edr
