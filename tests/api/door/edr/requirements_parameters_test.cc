// Requirements class "core" of OGC API-EDR 1.1: the query parameters, as defined and as answered.
#include <cmath>
#include <set>

#include "tests/api/door/edr/edr_service_for_tests.h"
#include "tests/api/door/edr/refusal.h"

namespace slackwater::tests::requirements_parameters_test {
namespace {

using nlohmann::json;

const EdrServiceForTests& service() { return edr_service(); }

constexpr const char* currents = "/collections/currents";
const std::string position = "/collections/currents/position";
const std::string corridor = "/collections/currents/corridor";

/// Half a unit of the sixth digit, of what is below 10 m/s.
constexpr double printed = 5e-6;

json all_of(const json& openapi, const std::string& path) {
  json parameters = json::object();
  for (json parameter : openapi.at("paths").at(path).at("get").at("parameters")) {
    if (parameter.contains("$ref")) {
      const auto pointer = parameter.at("$ref").get<std::string>().substr(1);
      parameter = openapi.at(json::json_pointer(pointer));
    }
    parameters[parameter.at("name").get<std::string>()] = parameter;
  }
  return parameters;
}

/// Checks a query parameter against the fragment that the standard gives for it.
void expect_defined(const std::string& query, const std::string& name, bool is_required,
                    const std::string& type = "string") {
  const json openapi = service().document("/api");
  for (const char* at :
       {"/collections/{collectionId}/", "/collections/{collectionId}/instances/{instanceId}/"}) {
    const json parameters = all_of(openapi, at + query);
    ASSERT_TRUE(parameters.contains(name)) << query << " takes no " << name;
    const json& parameter = parameters.at(name);
    EXPECT_EQ(parameter.at("in"), "query");
    EXPECT_EQ(parameter.at("required"), is_required) << query << " " << name;
    EXPECT_EQ(parameter.at("schema").at("type"), type);
    EXPECT_EQ(parameter.at("explode"), false);
  }
}

QueryPairs corridor_query(const QueryPairs& more = {}) {
  QueryPairs query{{"coords", "LINESTRING(2.41 57.21,2.44 57.21)"},
                   {"corridor-width", "1000"},
                   {"width-units", "m"},
                   {"corridor-height", "4"},
                   {"height-units", "m"},
                   {"z", "10"},
                   {"datetime", "2025-03-10T02:00:00Z"},
                   {"parameter-name", east_current}};
  for (const auto& pair : more) {
    std::erase_if(query, [&](const auto& known) { return known.first == pair.first; });
    if (!pair.second.empty()) query.push_back(pair);
  }
  return query;
}

/// The distinct values of one coordinate (0 time, 1 longitude, 2 latitude,
/// 3 vertical) over all paths.
std::set<double> places_of(const json& body, std::size_t coordinate) {
  std::set<double> places;
  for (const json& coverage : body.at("coverages"))
    for (const json& tuple : coverage.at("domain").at("axes").at("composite").at("values"))
      places.insert(tuple.at(coordinate).get<double>());
  return places;
}

TEST(EdrParameters, CoordsIsNeededTextWhereverThereIsAGeometry) {
  for (const char* query : {"position", "radius", "area", "trajectory", "corridor"})
    expect_defined(query, "coords", true);
}

TEST(EdrParameters, CoordsIsWellKnownTextInLongitudeAndLatitude) {
  const json body = service().document(position, {{"coords", "POINT(2.41 57.21)"},
                                                  {"z", "5"},
                                                  {"datetime", "2025-03-10T02:30:00Z"},
                                                  {"parameter-name", east_current}});
  const auto sample =
      service().in_force("farm")->current({2.41, 57.21, 5, parse_utc("2025-03-10T02:30:00Z")});
  EXPECT_NEAR(values_of(body, east_current).at(0), sample.velocity_m_s.real(), printed);
  // Latitude first is a place that no forecast reaches.
  EXPECT_TRUE(
      contains(service().refusal(404, position, {{"coords", "POINT(57.21 2.41)"}}), "farm"));
}

TEST(EdrParameters, ParameterNameIsAListOfNames) {
  for (const char* query : {"position", "radius", "area", "cube", "trajectory", "corridor"})
    expect_defined(query, "parameter-name", false, "array");
}

TEST(EdrParameters, OnlyNamedParametersAreReturnedAndAllWhereNoneIs) {
  const QueryPairs place{{"coords", "POINT(2.41 57.21)"}, {"datetime", "2025-03-10T02:00:00Z"}};
  QueryPairs named = place;
  named.emplace_back("parameter-name", std::string(north_current) + ",sea_water_speed");
  const json some = service().document(position, named);
  EXPECT_EQ(some.at("ranges").size(), 2U);
  EXPECT_TRUE(some.at("ranges").contains(north_current));
  EXPECT_TRUE(some.at("ranges").contains("sea_water_speed"));
  const json all = service().document(position, place);
  const json listed = service().document(currents).at("parameter_names");
  for (const auto& [name, described] : listed.items())
    EXPECT_TRUE(all.at("ranges").contains(name)) << name;
  EXPECT_EQ(all.at("ranges").size(), listed.size());
}

TEST(EdrParameters, CrsIsText) {
  for (const char* query : {"position", "radius", "area", "cube", "trajectory", "corridor"})
    expect_defined(query, "crs", false);
}

TEST(EdrParameters, EveryListedCrsIsServedAndNoOther) {
  const json listed = service().document(currents).at("crs");
  ASSERT_FALSE(listed.empty());
  for (const json& crs : listed) {
    const json body = service().document(
        position, {{"coords", "POINT(2.4 57.2)"}, {"z", "5"}, {"crs", crs.get<std::string>()}});
    EXPECT_EQ(body.at("domain").at("axes").at("x").at("values"), json({2.4}));
  }
  EXPECT_TRUE(contains(
      service().refusal(400, position, {{"coords", "POINT(2.4 57.2)"}, {"crs", "EPSG:3857"}}),
      "CRS84"));
}

TEST(EdrParameters, FIsText) {
  for (const char* query : {"position", "radius", "area", "cube", "trajectory", "corridor"})
    expect_defined(query, "f", false);
}

TEST(EdrParameters, EveryListedFormatIsServedAndNoOther) {
  const json link = service().document(currents).at("data_queries").at("position").at("link");
  const json listed = link.at("variables").at("output_formats");
  const QueryPairs place{{"coords", "POINT(2.4 57.2)"}, {"z", "5"}};
  std::set<std::string> media_types;
  for (const json& format : listed) {
    QueryPairs query = place;
    query.emplace_back("f", format.get<std::string>());
    const auto answer = service().get(position, query);
    EXPECT_EQ(answer.status, 200) << format;
    media_types.insert(answer.media_type);
  }
  EXPECT_EQ(media_types.size(), listed.size());
  EXPECT_EQ(link.at("variables").at("default_output_format"), "CoverageJSON");
  EXPECT_EQ(service().get(position, place).media_type, "application/prs.coverage+json");
  QueryPairs unknown = place;
  unknown.emplace_back("f", "GRIB");
  EXPECT_TRUE(contains(service().refusal(400, position, unknown), "CoverageJSON, GeoJSON"));
}

TEST(EdrParameters, ZIsText) {
  for (const char* query : {"position", "radius", "area", "cube", "trajectory", "corridor"})
    expect_defined(query, "z", false);
}

TEST(EdrParameters, ZIsALevelAListARangeOrASequence) {
  const auto levels = [&](const std::string& z) {
    const json body = service().document(
        position,
        {{"coords", "POINT(-2.55 48.85)"}, {"z", z}, {"datetime", "2025-03-11T03:00:00Z"}});
    return body.at("domain").at("axes").at("z").at("values");
  };
  EXPECT_EQ(levels("7"), json({7}));
  EXPECT_EQ(levels("2,12,5"), json({2, 5, 12}));
  EXPECT_EQ(levels("R4/1/3"), json({1, 4, 7, 10}));
  for (const json& level : levels("5/30")) {
    EXPECT_GE(level.get<double>(), 5);
    EXPECT_LE(level.get<double>(), 30);
  }
  EXPECT_EQ(levels("5/30").size(), 3U);  // 9.4, 18.3 and 27.2 m
}

TEST(EdrParameters, ZBetweenLevelsIsInterpolatedNotTheNearestLevel) {
  const auto field = service().in_force("lone");
  const auto& depths = field->snapshot().depth_m;
  const UtcTime time = field->snapshot().time[5];
  const double middle = 0.25 * depths[1] + 0.75 * depths[2];
  const json body = service().document(
      position,
      {{"coords", "POINT(-2.55 48.85)"},
       {"z", json(depths[1]).dump() + "," + json(middle).dump() + "," + json(depths[2]).dump()},
       {"datetime", format_utc(time)}});
  const auto& column = field->snapshot().columns.front();
  for (const char* name : {east_current, north_current}) {
    const std::vector<double> values = values_of(body, name);
    ASSERT_EQ(values.size(), 3U);
    // The stored values themselves, without any sampler between.
    const bool is_east = name == std::string(east_current);
    const auto stored = [&](std::size_t level) {
      const Horizontal w = column.current_m_s[5 * depths.size() + level];
      return is_east ? w.real() : w.imag();
    };
    EXPECT_NEAR(values[0], stored(1), printed);
    EXPECT_NEAR(values[2], stored(2), printed);
    EXPECT_NEAR(values[1], 0.25 * stored(1) + 0.75 * stored(2), printed);
    EXPECT_GT(std::abs(values[1] - values[2]), 4 * printed);
  }
}

TEST(EdrParameters, WithoutZThereAreAllLevels) {
  const json body = service().document(
      position, {{"coords", "POINT(-2.55 48.85)"}, {"datetime", "2025-03-11T03:00:00Z"}});
  EXPECT_EQ(body.at("domain").at("axes").at("z").at("values").size(),
            service().in_force("lone")->snapshot().depth_m.size());
}

TEST(EdrParameters, WithinIsNeededTextAndItsUnitsAreListed) {
  expect_defined("radius", "within", true);
  const json variables =
      service().document(currents).at("data_queries").at("radius").at("link").at("variables");
  EXPECT_FALSE(variables.at("within_units").empty());
}

TEST(EdrParameters, AllColumnsWithinTheRadiusAreReturned) {
  // From 2.40 E 57.20 N: 1.2 km to the next column east, 2.2 km to the next north.
  const auto columns = [&](const char* within, const char* units) {
    const json body =
        service().document("/collections/waves/radius", {{"coords", "POINT(2.40 57.20)"},
                                                         {"within", within},
                                                         {"within-units", units},
                                                         {"datetime", "2025-03-10T02:00:00Z"}});
    std::size_t filled = 0;
    for (const double value : values_of(body, "sea_surface_wave_significant_height"))
      filled += std::isnan(value) ? 0 : 1;
    return filled;
  };
  EXPECT_EQ(columns("0.5", "km"), 1U);
  EXPECT_EQ(columns("1500", "m"), 2U);
  EXPECT_EQ(columns("2.3", "km"), 3U);
  EXPECT_EQ(columns("50", "km"), 12U);
  EXPECT_TRUE(contains(service().refusal(400, "/collections/waves/radius",
                                         {{"coords", "POINT(2.40 57.20)"}, {"within", "5"}}),
                       "within-units"));
}

TEST(EdrParameters, WithinUnitsIsText) { expect_defined("radius", "within-units", true); }

TEST(EdrParameters, EveryListedUnitIsServedAndNoOther) {
  const json queries = service().document(currents).at("data_queries");
  for (const json& unit : queries.at("radius").at("link").at("variables").at("within_units")) {
    EXPECT_EQ(service()
                  .get("/collections/waves/radius", {{"coords", "POINT(2.43 57.22)"},
                                                     {"within", "2"},
                                                     {"within-units", unit.get<std::string>()}})
                  .status,
              200)
        << unit;
  }
  EXPECT_TRUE(
      contains(service().refusal(
                   400, "/collections/waves/radius",
                   {{"coords", "POINT(2.43 57.22)"}, {"within", "2"}, {"within-units", "furlong"}}),
               "km"));
}

TEST(EdrParameters, ResolutionXIsText) {
  for (const char* query : {"corridor", "cube", "area"})
    expect_defined(query, "resolution-x", false);
}

TEST(EdrParameters, ResolutionXCountsPositionsAcrossTheCorridorBordersIncluded) {
  // A path due east at 57.21 N, so that across is latitude: 500 m are
  // 0.0044966 degrees to either side.
  const double half_deg = 500.0 / 6371008.8 * 180 / 3.14159265358979;
  const auto across = [&](const char* count) {
    return places_of(service().document(corridor, corridor_query({{"resolution-x", count}})), 2);
  };
  const std::set<double> five = across("5");
  EXPECT_EQ(five.size(), 5U);
  EXPECT_NEAR(*five.begin(), 57.21 - half_deg, 2e-6);
  EXPECT_NEAR(*five.rbegin(), 57.21 + half_deg, 2e-6);
  // 0: no coarser than the columns stand (1.2 km), both borders in any case.
  EXPECT_EQ(across("0").size(), 2U);
  const json wide = service().document(
      corridor, corridor_query({{"corridor-width", "4000"}, {"resolution-x", "0"}}));
  EXPECT_EQ(places_of(wide, 2).size(), 5U);
}

TEST(EdrParameters, ZOfACubeIsALevelAListARangeOrASequence) {
  const auto levels = [&](const std::string& z) {
    const json body =
        service().document("/collections/currents/cube", {{"bbox", "2.39,57.19,2.43,57.21"},
                                                          {"z", z},
                                                          {"datetime", "2025-03-10T02:00:00Z"},
                                                          {"parameter-name", east_current}});
    return body.at("domain").at("axes").at("z").at("values");
  };
  EXPECT_EQ(levels("7"), json({7}));
  EXPECT_EQ(levels("2,12,5"), json({2, 5, 12}));
  EXPECT_EQ(levels("R3/0/10"), json({0, 10, 20}));
  EXPECT_EQ(levels("5/30").size(), 3U);
}

TEST(EdrParameters, ResolutionYIsText) {
  for (const char* query : {"corridor", "cube", "area"})
    expect_defined(query, "resolution-y", false);
}

TEST(EdrParameters, ResolutionYCountsPositionsAlongTheCorridorEndsIncluded) {
  const auto along = [&](const char* count) {
    return places_of(service().document(corridor, corridor_query({{"resolution-y", count}})), 1);
  };
  const std::set<double> seven = along("7");
  EXPECT_EQ(seven.size(), 7U);
  EXPECT_NEAR(*seven.begin(), 2.41, 1e-6);
  EXPECT_NEAR(*seven.rbegin(), 2.44, 1e-6);
  EXPECT_EQ(along("").size(), 2U);   // absent: the vertices
  EXPECT_EQ(along("0").size(), 3U);  // 0: 1.8 km at no more than 1.2 km apart
}

TEST(EdrParameters, ResolutionZIsText) {
  for (const char* query : {"corridor", "cube"}) expect_defined(query, "resolution-z", false);
}

TEST(EdrParameters, ResolutionZCountsPositionsOverTheHeightEndsIncluded) {
  const auto levels = [&](const QueryPairs& more) {
    return places_of(service().document(corridor, corridor_query(more)), 3);
  };
  EXPECT_EQ(levels({{"resolution-z", "5"}}), (std::set<double>{8, 9, 10, 11, 12}));
  // 0: the stored level between (9.4 m) and both ends.
  EXPECT_EQ(levels({{"resolution-z", "0"}}), (std::set<double>{8, 9.4, 12}));
}

TEST(EdrParameters, CorridorHeightIsNeededText) {
  expect_defined("corridor", "corridor-height", true);
}

TEST(EdrParameters, CorridorHeightIsTheWholeHeightAboutThePath) {
  const json body = service().document(corridor, corridor_query());
  EXPECT_EQ(places_of(body, 3), (std::set<double>{8, 10, 12}));
  const auto field = service().in_force("farm");
  const UtcTime time = parse_utc("2025-03-10T02:00:00Z");
  for (const json& coverage : body.at("coverages")) {
    const json& tuples = coverage.at("domain").at("axes").at("composite").at("values");
    const std::vector<double> values = values_of(coverage, east_current);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto sample = field->current({tuples[i][1], tuples[i][2], tuples[i][3], time});
      // Printed coordinates are rounded to 1e-7 degrees: a centimetre of a kilometre-wide gradient.
      EXPECT_NEAR(values[i], sample.velocity_m_s.real(), 2 * printed);
    }
  }
}

TEST(EdrParameters, HeightUnitsIsNeededText) { expect_defined("corridor", "height-units", true); }

TEST(EdrParameters, HeightIsMeasuredInItsUnits) {
  const json body = service().document(
      corridor, corridor_query({{"corridor-height", "0.004"}, {"height-units", "km"}}));
  EXPECT_EQ(places_of(body, 3), (std::set<double>{8, 10, 12}));
  EXPECT_TRUE(contains(service().refusal(400, corridor, corridor_query({{"height-units", "hPa"}})),
                       "height-units"));
}

TEST(EdrParameters, CorridorWidthIsNeededText) {
  expect_defined("corridor", "corridor-width", true);
}

TEST(EdrParameters, CorridorWidthIsTheWholeWidthAboutThePath) {
  const std::set<double> across = places_of(service().document(corridor, corridor_query()), 2);
  ASSERT_EQ(across.size(), 3U);
  EXPECT_NEAR((*across.rbegin() - *across.begin()) * 6371008.8 * 3.14159265358979 / 180, 1000, 0.5);
  EXPECT_NEAR(0.5 * (*across.rbegin() + *across.begin()), 57.21, 1e-6);
}

TEST(EdrParameters, WidthUnitsIsNeededText) { expect_defined("corridor", "width-units", true); }

TEST(EdrParameters, WidthIsMeasuredInItsUnits) {
  const json metres = service().document(corridor, corridor_query());
  const json kilometres = service().document(
      corridor, corridor_query({{"corridor-width", "1"}, {"width-units", "km"}}));
  EXPECT_EQ(places_of(metres, 2), places_of(kilometres, 2));
  EXPECT_TRUE(contains(service().refusal(400, corridor, corridor_query({{"width-units", "cubit"}})),
                       "width-units"));
}

}  // namespace
}  // namespace slackwater::tests::requirements_parameters_test
