// Queries that are small to ask and large to answer: refused with the limit,
// or answered in a moment.
#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

#include "tests/api/door/edr/edr_service_for_tests.h"
#include "tests/api/door/edr/made_up_store.h"

namespace slackwater::tests::heavy_queries_test {
namespace {

const EdrServiceForTests& service() { return edr_service(); }

constexpr const char* speed = "sea_water_speed";
constexpr const char* instant = "2025-03-10T06:00:00Z";
const std::string farm = "/collections/currents/instances/farm_20250310T050000Z";

/// A polygon that every parallel crosses `teeth` times.
std::string zigzag(int teeth) {
  std::string text = "POLYGON((2.39 57.19";
  for (int i = 0; i <= teeth; ++i) {
    const double x = 2.39 + 0.08 * i / teeth;
    text += "," + std::to_string(x) + (i % 2 == 0 ? " 57.191" : " 57.25");
  }
  return text + ",2.47 57.19,2.39 57.19))";
}

TEST(EdrHeavy, AShapeOfManyVerticesOverManyCellsIsRefusedInAMoment) {
  const auto start = std::chrono::steady_clock::now();
  const std::string told = service().refusal(400, farm + "/area",
                                             {{"coords", zigzag(1200)},
                                              {"z", "5"},
                                              {"datetime", instant},
                                              {"parameter-name", speed},
                                              {"resolution-x", "1000"},
                                              {"resolution-y", "1000"}});
  EXPECT_NE(told.find("simplify the area"), std::string::npos) << told;
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(15))
      << "it took 20 s of a thread that cannot be stopped";
  EXPECT_EQ(service()
                .get(farm + "/area", {{"coords", zigzag(1200)},
                                      {"z", "5"},
                                      {"datetime", instant},
                                      {"resolution-x", "40"},
                                      {"resolution-y", "40"}})
                .status,
            200)
      << "the same shape on a coarser grid";
}

TEST(EdrHeavy, AHundredThousandLinesAreRefused) {
  const std::string told = service().refusal(400, farm + "/corridor",
                                             {{"coords", "LINESTRING(2.41 57.21,2.42 57.21)"},
                                              {"corridor-width", "1"},
                                              {"width-units", "km"},
                                              {"corridor-height", "20"},
                                              {"height-units", "m"},
                                              {"parameter-name", speed},
                                              {"datetime", instant},
                                              {"resolution-x", "400"},
                                              {"resolution-z", "300"}});
  EXPECT_NE(told.find("120000 lines"), std::string::npos) << told;
}

TEST(EdrHeavy, MoreFeaturesThanAClientCanReadAreRefusedInGeoJsonAndServedInOtherFormats) {
  QueryPairs query{{"bbox", "2.39,57.19,2.47,57.25"},
                   {"z", "5"},
                   {"datetime", instant},
                   {"parameter-name", speed},
                   {"resolution-x", "600"},
                   {"resolution-y", "600"}};
  query.emplace_back("f", "GeoJSON");
  const std::string told = service().refusal(400, farm + "/cube", query);
  EXPECT_NE(told.find("360000 places"), std::string::npos) << told;
  query.back().second = "CoverageJSON";
  EXPECT_EQ(service().get(farm + "/cube", query).status, 200);
}

TEST(EdrHeavy, WhatTakesLongIsLeftToTheThreadsForIt) {
  const auto cube_of = [](const std::string& count) {
    return QueryPairs{{"bbox", "2.39,57.19,2.47,57.25"},
                      {"z", "5"},
                      {"datetime", instant},
                      {"parameter-name", speed},
                      {"resolution-x", count},
                      {"resolution-y", count}};
  };
  EXPECT_FALSE(service().takes_long(farm + "/cube", cube_of("200"))) << "40 000 values";
  EXPECT_TRUE(service().takes_long(farm + "/cube", cube_of("300"))) << "90 000 values";
  EXPECT_EQ(service().get(farm + "/cube", cube_of("300")).status, 200) << "and done there";
  const auto area_of = [](int corners, const std::string& count) {
    return QueryPairs{{"coords", zigzag(corners)}, {"z", "5"},
                      {"datetime", instant},       {"parameter-name", speed},
                      {"resolution-x", count},     {"resolution-y", count}};
  };
  EXPECT_FALSE(service().takes_long(farm + "/area", area_of(30, "20"))) << "24 000 comparisons";
  EXPECT_TRUE(service().takes_long(farm + "/area", area_of(1200, "60"))) << "four million";
  EXPECT_TRUE(service().takes_long(farm + "/area", area_of(1200, "2"))) << "long to read";
  EXPECT_FALSE(service().takes_long(farm + "/position", {{"coords", "POINT(2.42 57.22)"}}));
  EXPECT_FALSE(service().takes_long(farm + "/locations/farm", {{"z", "5"}}));
}

TEST(EdrHeavy, NoMoreIsDoneForWhoHasLeft) {
  const QueryPairs cube{{"bbox", "2.39,57.19,2.47,57.25"},
                        {"z", "5"},
                        {"datetime", instant},
                        {"parameter-name", speed},
                        {"resolution-x", "300"},
                        {"resolution-y", "300"}};
  const api::http::Response left = service().get_and_leave(farm + "/cube", cube);
  EXPECT_EQ(left.status, 503);
  EXPECT_NE(left.body.find("nobody waits"), std::string::npos) << left.body;
}

TEST(EdrHeavy, ACubeOfOneLevelHasItOnce) {
  const auto cube = service().document(farm + "/cube", {{"bbox", "2.39,57.19,6.7,2.47,57.25,6.7"},
                                                        {"datetime", instant},
                                                        {"parameter-name", speed}});
  EXPECT_EQ(cube.at("domain").at("axes").at("z").at("values"), nlohmann::json::array({6.7}));
}

TEST(EdrHeavy, TheWholeGlobeHoldsBothSidesOfTheAntimeridian) {
  const std::string at = "/collections/currents/instances/dateline_20250310T050000Z";
  const auto columns = [&](const std::string& query, const char* key, const std::string& value) {
    const auto cube = service().document(
        at + query, {{key, value}, {"z", "5"}, {"datetime", instant}, {"parameter-name", speed}});
    return cube.at("domain").at("axes").at("x").at("values").get<std::vector<double>>();
  };
  using Columns = std::vector<double>;
  const Columns both{179.99, 180.01};
  EXPECT_EQ(columns("/cube", "bbox", "-180,-90,180,90"), both);
  EXPECT_EQ(columns("/cube", "bbox", "0,-90,360,90"), both);
  EXPECT_EQ(columns("/area", "coords", "POLYGON((-180 -90,180 -90,180 90,-180 90,-180 -90))"),
            both);
  EXPECT_EQ(columns("/cube", "bbox", "179,-18,-179,-16"), both);
  EXPECT_EQ(columns("/cube", "bbox", "-180,-18,170,-16"), Columns{-179.99});
  EXPECT_EQ(columns("/cube", "bbox", "0,-18,180,-16"), Columns{179.99});
}

TEST(EdrHeavy, AHeadlineThatIsNotUtf8TakesNoDocumentAway) {
  EdrServiceForTests own;
  Snapshot made = lone_forecast(4, 3);
  made.headline = "Vent fort \xe0 l'ouest <script>";
  made.site_name = "Baie \xff";
  own.issue(made);
  for (const char* path : {"/collections", "/collections/currents/instances",
                           "/collections/currents/items", "/collections/currents/locations"}) {
    EXPECT_EQ(own.get(path).status, 200) << path;
    const api::http::Response page = own.get(path, {{"f", "html"}});
    EXPECT_EQ(page.status, 200) << path;
    EXPECT_EQ(page.body.find("<script>"), std::string::npos) << path;
  }
  const auto csv = own.get("/collections/currents/locations/lone", {{"z", "5"}, {"f", "CSV"}});
  ASSERT_EQ(csv.status, 200);
  for (const auto& [name, value] : csv.headers)
    for (const char c : value) EXPECT_TRUE(c >= ' ' && c <= '~') << name << ": " << value;
}

}  // namespace
}  // namespace slackwater::tests::heavy_queries_test
