// Requirements class "queries" of OGC API-EDR 1.1: what each query needs, refuses and answers.
#include <cmath>
#include <set>

#include "tests/api/door/edr/edr_service_for_tests.h"
#include "tests/api/door/edr/refusal.h"

namespace slackwater::tests::requirements_queries_test {
namespace {

using nlohmann::json;

const EdrServiceForTests& service() { return edr_service(); }

constexpr double printed = 5e-6;
constexpr const char* noon = "2025-03-10T02:00:00Z";
const std::string root = "/collections/currents/";

/// A query that leaves out one parameter is refused with a sentence that names it.
void expect_needed(const std::string& path, const QueryPairs& whole,
                   std::initializer_list<const char*> needed) {
  EXPECT_EQ(service().get(path, whole).status, 200) << service().get(path, whole).body;
  for (const std::string name : needed) {
    QueryPairs less = whole;
    std::erase_if(less, [&](const auto& pair) { return pair.first == name; });
    EXPECT_TRUE(contains(service().refusal(400, path, less), name)) << path << " without " << name;
  }
}

/// Every value of a grid is what the field holds at its cell.
void expect_sampled(const json& body, const Field& field) {
  const json& axes = body.at("domain").at("axes");
  const std::vector<double> values = values_of(body, east_current);
  std::size_t i = 0;
  for (const json& t : axes.at("t").at("values")) {
    for (const json& z : axes.at("z").at("values")) {
      for (const json& y : axes.at("y").at("values")) {
        for (const json& x : axes.at("x").at("values")) {
          const double value = values.at(i++);
          if (std::isnan(value)) continue;
          const auto sample = field.current({x, y, z, parse_utc(t.get<std::string>())});
          ASSERT_TRUE(has_value(sample.status));
          EXPECT_NEAR(value, sample.velocity_m_s.real(), printed);
        }
      }
    }
  }
  EXPECT_EQ(i, values.size());
}

TEST(EdrQueries, PositionAnswersAtPointsAndNeedsCoords) {
  const QueryPairs whole{{"coords", "MULTIPOINT((2.41 57.21),(2.45 57.23))"},
                         {"z", "3,20"},
                         {"datetime", noon},
                         {"parameter-name", east_current}};
  expect_needed(root + "position", whole, {"coords"});
  const json body = service().document(root + "position", whole);
  EXPECT_EQ(body.at("type"), "CoverageCollection");
  ASSERT_EQ(body.at("coverages").size(), 2U);
  const auto field = service().in_force("farm");
  for (const json& coverage : body.at("coverages")) {
    EXPECT_EQ(coverage.at("domain").at("domainType"), "VerticalProfile");
    expect_sampled(coverage, *field);
  }
  for (const char* wrong : {"POINT()", "POINT(x y)", "POINT(2.4)", "POLYGON((2 57,3 57,3 58,2 57))",
                            "LINESTRING(2 57,3 58)", ""}) {
    EXPECT_FALSE(service().refusal(400, root + "position", {{"coords", wrong}}).empty()) << wrong;
  }
}

TEST(EdrQueries, AreaAnswersWithinAPolygonAndNeedsCoords) {
  // A triangle over the three columns of the lower left corner.
  const QueryPairs whole{{"coords", "POLYGON((2.39 57.19,2.435 57.19,2.39 57.235,2.39 57.19))"},
                         {"z", "5"},
                         {"datetime", noon},
                         {"parameter-name", east_current}};
  expect_needed(root + "area", whole, {"coords"});
  const json body = service().document(root + "area", whole);
  EXPECT_EQ(body.at("domain").at("domainType"), "Grid");
  std::size_t filled = 0;
  for (const double value : values_of(body, east_current)) filled += std::isnan(value) ? 0 : 1;
  EXPECT_EQ(filled, 3U);
  expect_sampled(body, *service().in_force("farm"));
  for (const char* wrong : {"POLYGON()", "POLYGON((2 57,3 57,3 58))", "POINT(2.4 57.2)"})
    EXPECT_FALSE(service().refusal(400, root + "area", {{"coords", wrong}}).empty()) << wrong;
}

TEST(EdrQueries, CubeAnswersWithinABoxAndNeedsBboxAndZ) {
  const QueryPairs whole{{"bbox", "2.39,57.19,2.47,57.25"},
                         {"z", "0/20"},
                         {"datetime", "2025-03-10T01:00:00Z/2025-03-10T02:00:00Z"},
                         {"parameter-name", east_current}};
  expect_needed(root + "cube", whole, {"bbox", "z"});
  const json body = service().document(root + "cube", whole);
  EXPECT_EQ(body.at("ranges").at(east_current).at("shape"), json({2, 3, 3, 4}));
  expect_sampled(body, *service().in_force("farm"));
  // z overrules the levels of a box of six numbers.
  const json six = service().document(
      root + "cube", {{"bbox", "2.39,57.19,40,2.47,57.25,45"}, {"z", "5"}, {"datetime", noon}});
  EXPECT_EQ(six.at("domain").at("axes").at("z").at("values"), json({5}));
  for (const char* wrong : {"2.39,57.19,2.47", "a,b,c,d", "2,58,3,57", ""})
    EXPECT_FALSE(service().refusal(400, root + "cube", {{"bbox", wrong}, {"z", "5"}}).empty());
}

TEST(EdrQueries, ACubeAcrossTheAntimeridianHoldsBothSides) {
  const json body = service().document(
      root + "cube", {{"bbox", "179.9,-17.1,-179.9,-16.9"}, {"z", "5"}, {"datetime", noon}});
  const json& x = body.at("domain").at("axes").at("x").at("values");
  ASSERT_EQ(x.size(), 2U);
  EXPECT_NEAR(x[0].get<double>(), 179.99, 1e-6);
  EXPECT_NEAR(std::remainder(x[1].get<double>() + 179.99, 360.0), 0, 1e-6);
  expect_sampled(body, *service().in_force("dateline"));
}

TEST(EdrQueries, TrajectoryAnswersAlongALineAndNeedsCoords) {
  const QueryPairs whole{{"coords", "LINESTRING(2.41 57.21,2.43 57.22,2.45 57.23)"},
                         {"z", "5"},
                         {"datetime", noon},
                         {"parameter-name", east_current}};
  expect_needed(root + "trajectory", whole, {"coords"});
  for (const char* wrong : {"LINESTRING()", "LINESTRINGM()", "LINESTRINGZ()", "LINESTRINGZM()",
                            "LINESTRING(2 57)", "POINT(2.4 57.2)"})
    EXPECT_FALSE(service().refusal(400, root + "trajectory", {{"coords", wrong}}).empty()) << wrong;
}

TEST(EdrQueries, ATrajectoryTakesItsOwnLevelsAndTimes) {
  // 02:00 and 03:30 of 10 March 2025, in seconds since 1970.
  const json body = service().document(
      root + "trajectory",
      {{"coords", "LINESTRINGZM(2.41 57.21 5 1741572000,2.45 57.23 12 1741577400)"},
       {"parameter-name", east_current}});
  EXPECT_EQ(body.at("domain").at("domainType"), "Trajectory");
  const std::vector<double> values = values_of(body, east_current);
  ASSERT_EQ(values.size(), 2U);
  const auto field = service().in_force("farm");
  const auto first = field->current({2.41, 57.21, 5, parse_utc("2025-03-10T02:00:00Z")});
  const auto second = field->current({2.45, 57.23, 12, parse_utc("2025-03-10T03:30:00Z")});
  EXPECT_NEAR(values[0], first.velocity_m_s.real(), printed);
  EXPECT_NEAR(values[1], second.velocity_m_s.real(), printed);
}

TEST(EdrQueries, CorridorAnswersAboutALineAndNeedsItsWidthAndHeight) {
  const QueryPairs whole{{"coords", "LINESTRING(2.41 57.21,2.44 57.22)"},
                         {"corridor-width", "500"},
                         {"width-units", "m"},
                         {"corridor-height", "10"},
                         {"height-units", "m"},
                         {"datetime", noon}};
  expect_needed(root + "corridor", whole,
                {"coords", "corridor-width", "width-units", "corridor-height", "height-units"});
}

TEST(EdrQueries, ACorridorOfNoHeightAsOldClientsAskItIsOfItsPathsLevel) {
  QueryPairs flat{{"coords", "LINESTRINGZ(2.41 57.21 5,2.44 57.22 5)"},
                  {"corridor-width", "500"},
                  {"width-units", "m"},
                  {"datetime", noon},
                  {"parameter-name", east_current}};
  const json found = service().document(root + "corridor", flat);
  flat.push_back({"corridor-height", "0.001"});
  flat.push_back({"height-units", "m"});
  flat.push_back({"resolution-z", "1"});
  const json thin = service().document(root + "corridor", flat);
  ASSERT_EQ(found.at("coverages").size(), 3U);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(values_of(found.at("coverages")[i], east_current),
              values_of(thin.at("coverages")[i], east_current));
}

TEST(EdrQueries, RadiusAnswersAboutAPointAndNeedsItsDistance) {
  expect_needed(root + "radius",
                {{"coords", "POINT(2.42 57.22)"},
                 {"within", "3"},
                 {"within-units", "km"},
                 {"datetime", noon}},
                {"coords", "within", "within-units"});
}

TEST(EdrQueries, ItemsAreIssuedForecastsAsFeatures) {
  const json list = service().document("/collections/currents/items");
  EXPECT_EQ(list.at("type"), "FeatureCollection");
  EXPECT_EQ(list.at("features").size(), 4U);
  for (const json& feature : list.at("features")) {
    const auto id = feature.at("id").get<std::string>();
    EXPECT_EQ(service().document("/collections/currents/items/" + id).at("id"), id);
    const auto endpoint = feature.at("properties").at("edrqueryendpoint").get<std::string>();
    EXPECT_EQ(service().get(endpoint.substr(15)).status, 400);  // is there, and wants coords
  }
  EXPECT_FALSE(service().refusal(404, "/collections/currents/items/nothing").empty());
}

TEST(EdrQueries, LocationsAreListedWithTheirPlacesAndAnswer) {
  const json list = service().document("/collections/currents/locations");
  const auto field = service().in_force("farm");
  for (const json& feature : list.at("features")) {
    EXPECT_EQ(feature.at("geometry").at("type"), "Point");
    const auto endpoint = feature.at("properties").at("edrqueryendpoint").get<std::string>();
    EXPECT_EQ(service().get(endpoint.substr(15)).status, 200);
  }
  const json body = service().document("/collections/currents/locations/farm.5",
                                       {{"z", "5"}, {"datetime", noon}});
  const auto& column = field->snapshot().columns[5];
  const auto sample = field->current(
      {column.point.longitude_deg(), column.point.latitude_deg(), 5, parse_utc(noon)});
  EXPECT_NEAR(values_of(body, east_current).at(0), sample.velocity_m_s.real(), printed);
  for (const char* unknown : {"farm.12", "farm.-1", "farm.", "nobody", "lone.1"})
    EXPECT_FALSE(
        service().refusal(404, std::string("/collections/currents/locations/") + unknown).empty());
}

TEST(EdrQueries, QuantilesAndMembersAreParameters) {
  const UtcTime time = parse_utc("2025-03-11T04:00:00Z");
  const QueryPairs place{
      {"coords", "POINT(-2.55 48.85)"}, {"z", "5"}, {"datetime", "2025-03-11T04:00:00Z"}};
  const auto field = service().in_force("lone");
  const json body = service().document(root + "position", place);
  const auto quantiles = quantiles_of(field->current({-2.55, 48.85, 5, time}));
  EXPECT_NEAR(values_of(body, std::string(east_current) + "_p10").at(0), quantiles.p10_m_s.real(),
              printed);
  EXPECT_NEAR(values_of(body, std::string(north_current) + "_p90").at(0), quantiles.p90_m_s.imag(),
              printed);
  const json members = service().document("/collections/currents-members/position", place);
  for (const std::size_t m : {0U, 1U, 2U}) {
    const auto sample = field->current({-2.55, 48.85, 5, time}, m);
    EXPECT_NEAR(
        values_of(members, std::string(east_current) + "_member_" + std::to_string(m)).at(0),
        sample.velocity_m_s.real(), printed);
  }
}

TEST(EdrQueries, WhatIsNotThereIsARefusalWithTheValidRange) {
  const auto refused = [&](const QueryPairs& query) {
    return service().refusal(404, root + "position", query);
  };
  EXPECT_TRUE(contains(refused({{"coords", "POINT(40 10)"}}), "lone"));
  EXPECT_TRUE(
      contains(refused({{"coords", "POINT(2.4 57.2)"}, {"datetime", "2024-01-01T00:00:00Z"}}),
               "2025-03-10T00:00:00Z/2025-03-10T12:00:00Z"));
  EXPECT_TRUE(contains(refused({{"coords", "POINT(2.4 57.2)"}, {"z", "4000"}}), "depth 0 to 50 m"));
}

TEST(EdrQueries, BelowTheBedIsNoNumberButASentence) {
  const json body = service().document(
      root + "position", {{"coords", "POINT(2.42 57.20)"}, {"z", "5,49"}, {"datetime", noon}});
  const std::vector<double> values = values_of(body, east_current);
  EXPECT_FALSE(std::isnan(values.at(0)));
  EXPECT_TRUE(std::isnan(values.at(1)));  // the bed is at 44 m there
  EXPECT_TRUE(contains(body.at("slackwater:provenance").at("notes").dump(), "below"));
}

}  // namespace
}  // namespace slackwater::tests::requirements_queries_test
