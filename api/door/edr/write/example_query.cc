#include "api/door/edr/write/example_query.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "fields/base/encode/percent.h"

namespace slackwater::api::edr {
namespace {

constexpr double usual_level_m = 10;

std::string shortest(double value) { return nlohmann::json(value).dump(); }

Example example_at(const Snapshot& snapshot, UtcTime time) {
  const ForecastColumn& column = snapshot.columns.front();
  Example example;
  example.site = snapshot.site_id;
  example.longitude_deg = column.point.longitude_deg();
  example.latitude_deg = column.point.latitude_deg();
  example.time = time;
  example.depth_m = std::min(usual_level_m, std::floor(5 * column.water_depth_m) / 10);
  return example;
}

bool has_values(const Collection& collection, const Field& field, const Example& example) {
  Place place{example.longitude_deg, example.latitude_deg, usual_level_m, example.time};
  if (std::holds_alternative<Quantities<WindSample>>(collection.quantities)) {
    WindSample wind;
    field.sample_wind({&place, 1}, {&wind, 1});
    return has_value(wind.status);
  }
  if (std::holds_alternative<Quantities<SeaSample>>(collection.quantities)) {
    SeaSample sea;
    field.sample_sea({&place, 1}, {&sea, 1});
    return has_value(sea.status);
  }
  if (std::holds_alternative<Quantities<SeaLevelSample>>(collection.quantities)) {
    SeaLevelSample level;
    field.sample_sea_level({&place, 1}, {&level, 1});
    return has_value(level.status);
  }
  place.vertical_m = example.depth_m;
  return has_value(field.current(place).status);
}

}  // namespace

Example example_of(const ForecastCatalogue& catalogue) {
  if (catalogue.sites.empty()) return {};
  const auto& site = catalogue.sites.front();
  const Snapshot& snapshot = site.field->snapshot();
  Example example = example_at(snapshot, snapshot.time[snapshot.time.size() / 2]);
  example.instance = site.instance;
  return example;
}

std::optional<Example> example_of(const Collection& collection, const Field& field) {
  const std::vector<UtcTime>& time = field.snapshot().time;
  for (std::size_t i = 0; i < time.size(); ++i) {  // from the middle onwards, then from the start
    const Example example = example_at(field.snapshot(), time[(i + time.size() / 2) % time.size()]);
    if (has_values(collection, field, example)) return example;
  }
  return std::nullopt;
}

std::string example_coords(std::string_view query, const Example& example) {
  const auto at = [&](double east, double north) {
    return shortest(example.longitude_deg + east) + " " + shortest(example.latitude_deg + north);
  };
  if (query == "area") {
    return "POLYGON((" + at(-0.02, -0.02) + "," + at(0.02, -0.02) + "," + at(0.02, 0.02) + "," +
           at(-0.02, -0.02) + "))";
  }
  if (query == "trajectory" || query == "corridor")
    return "LINESTRING(" + at(0, 0) + "," + at(0.01, 0.01) + ")";
  return "POINT(" + at(0, 0) + ")";
}

std::string example_value(std::string_view name, std::string_view query, const Example& example) {
  const double x = example.longitude_deg;
  const double y = example.latitude_deg;
  if (name == "coords") return example_coords(query, example);
  if (name == "bbox") {
    return shortest(x - 0.1) + "," + shortest(y - 0.1) + "," + shortest(x + 0.1) + "," +
           shortest(y + 0.1);
  }
  if (name == "within") return "5";
  if (name == "within-units") return "km";
  if (name == "corridor-width") return "1000";
  if (name == "corridor-height") return "2";
  return "m";  // width-units, height-units
}

std::string example_query(const QueryType& type, const Collection& collection,
                          const Example& example) {
  std::vector<std::string_view> names(
      type.parameters.begin(), type.parameters.begin() + static_cast<std::ptrdiff_t>(type.needed));
  if (std::find(names.begin(), names.end(), "z") == names.end()) names.emplace_back("z");
  const std::string level =
      shortest(collection.vertical == Vertical::depth_down ? example.depth_m : usual_level_m);
  std::string query;
  for (const std::string_view name : names) {
    const bool is_vertical = name == "z" || name == "corridor-height" || name == "height-units";
    if (is_vertical && collection.vertical == Vertical::none) continue;
    query += (query.empty() ? "" : "&") + std::string(name) + "=" +
             percent_encoded(name == "z" ? level : example_value(name, type.name, example));
  }
  return query + "&datetime=" + percent_encoded(format_utc(example.time));
}

}  // namespace slackwater::api::edr
