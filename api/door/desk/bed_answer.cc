#include "api/door/desk/bed_answer.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "api/door/desk/asked_words.h"
#include "api/door/desk/site_list.h"
#include "api/pipeline/bed_around.h"
#include "fields/grid/isolines.h"

namespace slackwater::api::desk {
namespace {

using nlohmann::json;

constexpr double depths_m[] = {5, 10, 20, 30, 50, 100, 200, 500, 1000};
constexpr std::size_t most_nodes = 1000;  // along a side
/// Depths are stored as sea_floor_depth_below_geoid.
constexpr const char* datum = "geoid (mean sea level)";

std::vector<std::size_t> every_nth(std::size_t count) {
  const std::size_t step = (count + most_nodes - 1) / most_nodes;
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < count; i += step) kept.push_back(i);
  return kept;
}

struct Depths {
  std::vector<double> longitude_deg, latitude_deg;
  std::vector<float> depth_m;
};

Depths thinned(const GriddedField& field) {
  const Grid& grid = field.grid;
  const auto columns = every_nth(grid.columns()), rows = every_nth(grid.rows());
  Depths out;
  for (const std::size_t i : columns) out.longitude_deg.push_back(grid.longitude_deg[i]);
  for (const std::size_t j : rows) {
    out.latitude_deg.push_back(grid.latitude_deg[j]);
    for (const std::size_t i : columns)
      out.depth_m.push_back(field.values[grid.offset(0, 0, j, i)]);
  }
  return out;
}

/// To a metre.
double rounded(double degrees) { return std::round(degrees * 1e5) / 1e5; }

json line_json(const Isoline& line) {
  json points = json::array();
  for (const auto& [x, y] : line) points.push_back({rounded(x), rounded(y)});
  return points;
}

}  // namespace

json bed_json(const ScalarPiece& bed) {
  const Depths depths = thinned(bed.field);
  json features = json::array();
  for (const double depth_m : depths_m) {
    json lines = json::array();
    for (const Isoline& line :
         isolines(depths.longitude_deg, depths.latitude_deg, depths.depth_m, depth_m))
      lines.push_back(line_json(line));
    if (lines.empty()) continue;
    features.push_back(
        {{"type", "Feature"},
         {"properties",
          {{"depth_m", depth_m}, {"product", bed.origin.product_id}, {"datum", datum}}},
         {"geometry", {{"type", "MultiLineString"}, {"coordinates", lines}}}});
  }
  return {{"type", "FeatureCollection"},
          {"product", bed.origin.product_id},
          {"datum", datum},
          {"attribution", bed.origin.attribution},
          {"features", std::move(features)}};
}

json bed_answer(const Answers& from, const std::string& id, const std::string& query) {
  static_cast<void>(AskedWords(query, {}));  // it has none
  const Site site = described_site(id, from.store_folder);
  store::Store store = store::Store::open(from.store_folder, store::OpenMode::read_only);
  return bed_json(bed_around(store, site));
}

}  // namespace slackwater::api::desk
