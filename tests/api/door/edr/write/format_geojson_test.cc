#include "api/door/edr/write/format_geojson.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/api/door/edr/made_up_answer.h"

namespace slackwater::api::edr::format_geojson_test {
namespace {

using nlohmann::json;
using tests::made_up_answer;
using tests::made_up_value;

constexpr const char* east = "eastward_sea_water_velocity";

json features(DomainType type, std::size_t coverages = 1) {
  return json::parse(geojson(made_up_answer(type, coverages))).at("features");
}

TEST(GeoJson, APlaceIsAFeatureWithWhatEdrAsksFor) {
  const json body = json::parse(geojson(made_up_answer(DomainType::point, 2)));
  EXPECT_EQ(body.at("type"), "FeatureCollection");
  EXPECT_EQ(body.at("numberReturned"), 2);
  ASSERT_EQ(body.at("features").size(), 2U);
  const json& second = body.at("features")[1];
  EXPECT_EQ(second.at("type"), "Feature");
  EXPECT_EQ(second.at("geometry"), json::parse(R"({"type":"Point","coordinates":[3.45,57.25]})"));
  const json& properties = second.at("properties");
  EXPECT_EQ(properties.at("datetime"), "2025-03-10T00:00:00Z");
  EXPECT_EQ(properties.at("label"), "place-1");
  EXPECT_EQ(properties.at("parameter-name").size(), 3U);
  EXPECT_TRUE(properties.at("edrqueryendpoint").get<std::string>().starts_with("http://"));
  EXPECT_DOUBLE_EQ(properties.at(east).get<double>(), made_up_value(1, 0, 0));
  EXPECT_TRUE(properties.at("northward_sea_water_velocity").is_null());
  EXPECT_EQ(properties.at("depth_m"), json({10}));
}

TEST(GeoJson, ASeriesAndAProfileAreLists) {
  const json series = features(DomainType::point_series)[0].at("properties");
  EXPECT_EQ(series.at("datetime"), "2025-03-10T00:00:00Z/2025-03-11T00:00:00Z");
  EXPECT_EQ(series.at("time").size(), 25U);
  ASSERT_EQ(series.at(east).size(), 25U);
  EXPECT_NEAR(series.at(east)[24].get<double>(), made_up_value(0, 0, 24), 1e-9);
  const json profile = features(DomainType::vertical_profile)[0].at("properties");
  EXPECT_EQ(profile.at("depth_m"), json({0.5, 10.5, 20.5, 30.5}));
  EXPECT_NEAR(profile.at(east)[3].get<double>(), made_up_value(0, 0, 3), 1e-9);
}

TEST(GeoJson, AGridIsAFeaturePerCellWithListsOfLists) {
  const json cells = features(DomainType::grid);
  ASSERT_EQ(cells.size(), 6U);
  // Row 1, column 2; time 1, level 3: index ((1 * 4 + 3) * 2 + 1) * 3 + 2.
  const json& cell = cells[5];
  EXPECT_EQ(cell.at("geometry").at("coordinates"), json({2.65, 57.3125}));
  EXPECT_NEAR(cell.at("properties").at(east)[1][3].get<double>(), made_up_value(0, 0, 47), 1e-9);
  EXPECT_TRUE(cells[0].at("properties").at("northward_sea_water_velocity")[0][0].is_null());
}

TEST(GeoJson, ATrajectoryIsAFeaturePerVertex) {
  const json vertices = features(DomainType::trajectory);
  ASSERT_EQ(vertices.size(), 5U);
  const json& properties = vertices[4].at("properties");
  EXPECT_EQ(properties.at("datetime"), "2025-03-10T04:00:00Z");
  EXPECT_EQ(properties.at("depth_m"), json({20}));
  EXPECT_NEAR(properties.at(east).get<double>(), made_up_value(0, 0, 4), 1e-9);
}

TEST(GeoJson, ParametersAndProvenanceStandBesideTheFeatures) {
  const json body = json::parse(geojson(made_up_answer(DomainType::point)));
  EXPECT_EQ(body.at("parameters")[2].at("id"), "eastward_sea_water_velocity_p10");
  EXPECT_EQ(body.at("slackwater:provenance").at("degraded"), true);
  EXPECT_EQ(body.at("links")[0].at("rel"), "self");
}

}  // namespace
}  // namespace slackwater::api::edr::format_geojson_test
