// Every query parameter malformed, out of range, absent, repeated, unknown and hostile:
// a refusal with a reason.
#include <chrono>
#include <map>

#include "tests/api/door/edr/edr_service_for_tests.h"
#include "tests/api/door/edr/refusal.h"

namespace slackwater::tests::hostile_queries_test {
namespace {

using nlohmann::json;

const EdrServiceForTests& service() { return edr_service(); }

/// A query of each kind that is answered as it stands.
const std::map<std::string, QueryPairs>& whole_queries() {
  static const QueryPairs common{{"datetime", "2025-03-10T02:00:00Z"},
                                 {"parameter-name", east_current},
                                 {"crs", "CRS84"},
                                 {"f", "CoverageJSON"},
                                 {"z", "5"}};
  const auto with = [](QueryPairs more) {
    more.insert(more.end(), common.begin(), common.end());
    return more;
  };
  static const std::map<std::string, QueryPairs> all{
      {"position", with({{"coords", "POINT(2.41 57.21)"}})},
      {"radius", with({{"coords", "POINT(2.41 57.21)"}, {"within", "3"}, {"within-units", "km"}})},
      {"area", with({{"coords", "POLYGON((2.39 57.19,2.45 57.19,2.45 57.23,2.39 57.19))"},
                     {"resolution-x", "3"},
                     {"resolution-y", "3"}})},
      {"cube", with({{"bbox", "2.39,57.19,2.45,57.23"}, {"resolution-z", "1"}})},
      {"trajectory", with({{"coords", "LINESTRING(2.41 57.21,2.43 57.22)"}})},
      {"corridor", with({{"coords", "LINESTRING(2.41 57.21,2.43 57.22)"},
                         {"corridor-width", "500"},
                         {"width-units", "m"},
                         {"corridor-height", "4"},
                         {"height-units", "m"}})},
      {"locations/farm", common}};
  return all;
}

/// What no parameter of that name may be.
const std::map<std::string, std::vector<std::string>>& wrong_values() {
  static const std::vector<std::string> no_number{"", "five", "nan", "inf", "-3", "1e999", "0x10"};
  static const std::vector<std::string> no_unit{"", "parsec", "m;km", "M\nKM"};
  static const std::vector<std::string> no_count{"", "-1", "1.5", "1001", "many", "99999999999"};
  static const std::map<std::string, std::vector<std::string>> all{
      {"coords",
       {"", "POINT", "POINT(", "POINT(1)", "POINT(1 2 3 4 5)", "POINT(nan 57)", "POINT(1e999 57)",
        "POINT(2 91)", "POINT(999 57)", "CIRCLE(2 57)", "POINT(2 57))", "../../etc/passwd",
        "<script>alert(1)</script>", "'; DROP TABLE forecasts; --",
        long_text("POINT(2 57", 300'000, '(')}},
      {"bbox", {"", "1,2,3", "1,2,3,4,5,6,7", "nan,0,1,1", "2,58,3,57", "-999,0,1,1", "a,b,c,d"}},
      {"datetime",
       {"", "yesterday", "2025-13-01T00:00:00Z", "2025-03-10T25:00:00Z", "2025-03-10T00:00:00",
        "2025-03-11/2025-03-10", "/", "a/b/c", long_text("2025", 5000, '0')}},
      {"z",
       {"", "deep", "5/", "/5", "50/0", "1,,2", "R0/1/1", "R5/1", "R99999999/0/1", "nan", "1e999",
        long_text("1", 40'000, ',')}},
      {"parameter-name", {"", "salt", ",", "eastward_sea_water_velocity,salt", "*"}},
      {"crs", {"", "EPSG:3857", "CRS85", "../CRS84"}},
      {"f", {"", "GRIB", "html5", "../json", "application/x-hdf"}},
      {"within", no_number},
      {"within-units", no_unit},
      {"corridor-width", no_number},
      {"width-units", no_unit},
      {"corridor-height", no_number},
      {"height-units", no_unit},
      {"resolution-x", no_count},
      {"resolution-y", no_count},
      {"resolution-z", no_count}};
  return all;
}

/// Refused with a sentence, in a moment, and without the service's insides.
void expect_refused(const api::http::Response& answer, const std::string& what) {
  EXPECT_GE(answer.status, 400) << what;
  EXPECT_LT(answer.status, 500) << what;
  EXPECT_EQ(answer.media_type, "application/problem+json") << what;
  const json body = json::parse(answer.body, nullptr, false);
  ASSERT_TRUE(body.is_object()) << what;
  const auto detail = body.at("detail").get<std::string>();
  EXPECT_GT(detail.size(), 20U) << what;
  EXPECT_LT(detail.size(), 1200U) << what;
  EXPECT_EQ(detail.find(".cc"), std::string::npos) << detail;
}

QueryPairs changed(QueryPairs query, const std::string& name, const std::string& value) {
  for (auto& [key, old] : query)
    if (key == name) old = value;
  return query;
}

TEST(EdrHostile, EachQueryIsAnsweredAsItStands) {
  for (const auto& [kind, query] : whole_queries()) {
    const auto answer = service().get("/collections/currents/" + kind, query);
    EXPECT_EQ(answer.status, 200) << kind << ": " << answer.body.substr(0, 300);
  }
}

TEST(EdrHostile, EachParameterOfEachQueryRefusesWhatItCannotRead) {
  for (const auto& [kind, query] : whole_queries()) {
    const std::string path = "/collections/currents/" + kind;
    for (const auto& [name, value] : query) {
      for (const std::string& wrong : wrong_values().at(name)) {
        const auto answer = service().get(path, changed(query, name, wrong));
        expect_refused(answer, kind + "?" + name + "=" + wrong.substr(0, 60));
      }
    }
  }
}

TEST(EdrHostile, AParameterMayStandOnceAndMustBeKnown) {
  for (const auto& [kind, query] : whole_queries()) {
    const std::string path = "/collections/currents/" + kind;
    for (const auto& pair : query) {
      QueryPairs twice = query;
      twice.push_back(pair);
      EXPECT_TRUE(contains(service().refusal(400, path, twice), pair.first)) << kind;
    }
    QueryPairs more = query;
    more.emplace_back("depth", "5");
    EXPECT_TRUE(contains(service().refusal(400, path, more), "takes ")) << kind;
  }
}

TEST(EdrHostile, ListsRefuseWhatTheyCannotRead) {
  for (const char* path : {"/collections/currents/items", "/collections/currents/locations"}) {
    for (const auto& [name, value] : QueryPairs{{"bbox", "1,2,3"},
                                                {"datetime", "soon"},
                                                {"limit", "0"},
                                                {"limit", "-1"},
                                                {"limit", "ten"},
                                                {"offset", "-1"},
                                                {"f", "GRIB"},
                                                {"colour", "red"}})
      expect_refused(service().get(path, {{name, value}}), path + ("?" + name) + "=" + value);
  }
  for (const char* path : {"/", "/api", "/conformance", "/collections", "/collections/currents",
                           "/collections/currents/instances"}) {
    expect_refused(service().get(path, {{"f", "GRIB"}}), path);
    expect_refused(service().get(path, {{"bbox", "1,2,3,4"}}), path);
  }
}

TEST(EdrHostile, BrokenQueryStringsAreRefused) {
  const std::string path = "/collections/currents/position";
  std::string flood;
  for (int i = 0; i < 1000; ++i) flood += "a" + std::to_string(i) + "=1&";
  for (const std::string& query :
       {std::string("coords=POINT%2"), std::string("coords=%zz"), std::string("=POINT(1 2)"),
        std::string("coords=POINT%28%00%29"), std::string("coords"), flood,
        std::string("coords=POINT(2 57)&coords=POINT(2 57)"), std::string(300'000, 'x')})
    expect_refused(service().get_raw(path, query), query.substr(0, 60));
}

TEST(EdrHostile, PathsThatLeadOutsideLeadNowhere) {
  for (const char* path :
       {"/collections/..%2f..%2fetc/position", "/collections/%2e%2e/position",
        "/collections/currents/instances/..%2f..%2fstore/position",
        "/collections/currents/instances/%00/position", "/collections/currents/locations/%2e%2e",
        "/collections//position", "/collections/currents/items/lone_20250310T050000Z.nc"})
    expect_refused(service().get(path, {{"coords", "POINT(2.4 57.2)"}}), path);
}

TEST(EdrHostile, TooMuchAtOnceIsRefusedInAMoment) {
  const auto start = std::chrono::steady_clock::now();
  expect_refused(service().get("/collections/currents/cube", {{"bbox", "2.39,57.19,2.45,57.23"},
                                                              {"z", "R1000/0/0.04"},
                                                              {"resolution-x", "1000"},
                                                              {"resolution-y", "1000"}}),
                 "a cube of 1e9 cells");
  expect_refused(service().get("/collections/currents/area",
                               {{"coords", "POLYGON((-180 -90,180 -90,180 90,-180 90,-180 -90))"},
                                {"resolution-x", "1000"},
                                {"resolution-y", "1000"}}),
                 "the globe");
  std::string line = "LINESTRING(2.41 57.21";
  for (int i = 0; i < 20'000; ++i) line += ",2.42 57.21";
  expect_refused(service().get("/collections/currents/trajectory", {{"coords", line}}),
                 "20 000 vertices");
  const auto spent = std::chrono::steady_clock::now() - start;
  EXPECT_LT(spent, std::chrono::seconds(5));
}

}  // namespace
}  // namespace slackwater::tests::hostile_queries_test
