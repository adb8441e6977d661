#include "api/door/edr/write/features.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "api/door/edr/write/example_query.h"
#include "api/door/edr/write/feature_page.h"
#include "fields/base/encode/percent.h"
#include "fields/geo/coverage.h"

namespace slackwater::api::edr {
namespace {

using nlohmann::json;

/// An archive of years is more than one answer may hold.
constexpr Duration shown_of_product = std::chrono::days(7);

std::string name_of_column(const std::string& site, std::size_t column) {
  return column == 0 ? site : site + "." + std::to_string(column);
}

json names_of(const Collection& collection, std::size_t members) {
  json names = json::array();
  for (const Parameter& parameter : parameters_of(collection, members))
    names.push_back(parameter.name);
  return names;
}

/// To itself, to its other renditions, to where its values are had and to what it holds.
json feature_links(const std::string& href, const std::string& data) {
  return {
      {{"href", href}, {"rel", "self"}, {"type", "application/geo+json"}},
      {{"href", href + "?f=json"}, {"rel", "alternate"}, {"type", "application/json"}},
      {{"href", href + "?f=html"}, {"rel", "alternate"}, {"type", "text/html"}},
      {{"href", data + "/position"}, {"rel", "data"}, {"type", "application/prs.coverage+json"}},
      {{"href", data},
       {"rel", "describedby"},
       {"type", "application/json"},
       {"title", "What this forecast holds"}}};
}

slackwater::BoundingBox box_of(const ForecastCatalogue& catalogue, const std::string& site_id) {
  for (const auto& site : catalogue.sites)
    if (site.site_id == site_id) return site.field->range().box;
  return {-180, -90, 180, 90};
}

/// Values that are there as CSV.
struct CsvLink {
  std::string title;
  std::string query;  ///< behind "?f=csv"
};

json location(const std::string& at, const Snapshot& snapshot, std::size_t c, UtcTime from,
              UtcTime to, const json& names, const std::optional<CsvLink>& csv) {
  const ForecastColumn& column = snapshot.columns[c];
  const std::string id = name_of_column(snapshot.site_id, c);
  const std::string label =
      c == 0 ? snapshot.site_name : snapshot.site_name + ", column " + std::to_string(c);
  const std::string endpoint = at + "/locations/" + percent_encoded(id);
  json links = json::array();
  if (csv) {
    links.push_back({{"href", endpoint + "?f=csv" + csv->query},
                     {"rel", "data"},
                     {"type", "text/csv"},
                     {"title", csv->title}});
  }
  return {{"type", "Feature"},
          {"id", id},
          {"links", links},
          {"geometry",
           {{"type", "Point"},
            {"coordinates", {column.point.longitude_deg(), column.point.latitude_deg()}}}},
          {"properties",
           {{"datetime", format_utc(from) + "/" + format_utc(to)},
            {"parameter-name", names},
            {"label", label},
            {"edrqueryendpoint", endpoint},
            {"water_depth_m", column.water_depth_m}}}};
}

/// Where an instrument stands.
json platform(const std::string& at, const StoredProduct& product, const json& names,
              const CsvLink& csv) {
  const std::string id = own_location(product);
  const std::string endpoint = at + "/locations/" + percent_encoded(id);
  const GeoPoint place = place_of(product);
  return {{"type", "Feature"},
          {"id", id},
          {"links", json::array({{{"href", endpoint + "?f=csv" + csv.query},
                                  {"rel", "data"},
                                  {"type", "text/csv"},
                                  {"title", csv.title}}})},
          {"geometry",
           {{"type", "Point"}, {"coordinates", {place.longitude_deg(), place.latitude_deg()}}}},
          {"properties",
           {{"datetime", format_utc(product.from) + "/" + format_utc(product.to)},
            {"parameter-name", names},
            {"label", product.station},
            {"edrqueryendpoint", endpoint}}}};
}

json footprint(const slackwater::BoundingBox& box) {
  const double east = box.east_deg < box.west_deg ? box.east_deg + 360 : box.east_deg;
  return {{"type", "Polygon"},
          {"coordinates",
           {{{box.west_deg, box.south_deg},
             {east, box.south_deg},
             {east, box.north_deg},
             {box.west_deg, box.north_deg},
             {box.west_deg, box.south_deg}}}}};
}

}  // namespace

json locations_document(const std::string& at, const Collection& collection,
                        const std::vector<std::shared_ptr<const Field>>& fields,
                        const QueryString& query) {
  const FeatureFilter filter(query);
  json features = json::array();
  for (const auto& field : fields) {
    const Snapshot& snapshot = field->snapshot();
    const UtcTime from = snapshot.time.front();
    const UtcTime to = snapshot.time.back();
    const json names = names_of(collection, snapshot.members);
    std::optional<CsvLink> csv;
    if (example_of(collection, *field)) csv = {collection.title + " as CSV", ""};
    for (std::size_t c = 0; c < snapshot.columns.size(); ++c) {
      const GeoPoint& point = snapshot.columns[c].point;
      if (!filter.takes(slackwater::box_of(point), from, to)) continue;
      features.push_back(location(at, snapshot, c, from, to, names, csv));
    }
  }
  return feature_page(at + "/locations", filter, std::move(features));
}

json product_locations_document(const std::string& at, const StoredProduct& product,
                                const ForecastCatalogue& catalogue, const QueryString& query) {
  const FeatureFilter filter(query);
  json names = json::array();
  for (const Parameter& parameter : parameters_of(product)) names.push_back(parameter.name);
  const std::string last_days = format_utc(std::max(product.from, product.to - shown_of_product)) +
                                "/" + format_utc(product.to);
  const CsvLink csv{"The last days of " + title_of(product) + " as CSV",
                    "&datetime=" + percent_encoded(last_days)};
  json features = json::array();
  if (product.is_measured() &&
      filter.takes(slackwater::box_of(place_of(product)), product.from, product.to))
    features.push_back(platform(at, product, names, csv));
  for (const auto& site : catalogue.sites) {
    const Snapshot& snapshot = site.field->snapshot();
    for (std::size_t c = 0; c < snapshot.columns.size(); ++c) {
      const GeoPoint& point = snapshot.columns[c].point;
      if (!product.bounds.contains(point) ||
          !filter.takes(slackwater::box_of(point), product.from, product.to))
        continue;
      features.push_back(location(at, snapshot, c, product.from, product.to, names, csv));
    }
  }
  return feature_page(at + "/locations", filter, std::move(features));
}

json item_document(const std::string& base, const Collection& collection,
                   const ForecastCatalogue& catalogue, const IssuedForecast& forecast) {
  const std::string at = base + "/collections/" + collection.id;
  const std::string data = at + "/instances/" + percent_encoded(forecast.instance);
  std::size_t members = 1;
  for (const auto& site : catalogue.sites)
    if (site.site_id == forecast.row.site_id) members = site.field->snapshot().members;
  return {
      {"type", "Feature"},
      {"id", forecast.instance},
      {"geometry", footprint(box_of(catalogue, forecast.row.site_id))},
      {"links", feature_links(at + "/items/" + percent_encoded(forecast.instance), data)},
      {"properties",
       {{"datetime", format_utc(forecast.row.valid_from) + "/" + format_utc(forecast.row.valid_to)},
        {"parameter-name", names_of(collection, members)},
        {"label", forecast.row.site_id + ", issued " + format_utc(forecast.row.issued)},
        {"edrqueryendpoint", data + "/position"},
        {"site", forecast.row.site_id},
        {"day", format_day(forecast.row.day)},
        {"issued", format_utc(forecast.row.issued)},
        {"wind", name_of(forecast.row.wind_policy)},
        {"origin", name_of(forecast.row.origin)},
        {"degraded", forecast.row.degraded},
        {"headline", forecast.row.headline},
        {"code_version", forecast.row.code_version}}}};
}

json items_document(const std::string& base, const Collection& collection,
                    const ForecastCatalogue& catalogue, const QueryString& query) {
  const FeatureFilter filter(query);
  json features = json::array();
  for (const IssuedForecast& forecast : catalogue.instances) {
    if (!filter.takes(box_of(catalogue, forecast.row.site_id), forecast.row.valid_from,
                      forecast.row.valid_to)) {
      continue;
    }
    features.push_back(item_document(base, collection, catalogue, forecast));
  }
  return feature_page(base + "/collections/" + collection.id + "/items", filter,
                      std::move(features));
}

}  // namespace slackwater::api::edr
