// Requirements classes "json", "geojson", "edr-geojson" and "covjson" of OGC API-EDR 1.1. Schemas
// are checked by strangers (tests/strangers/edr-conformance); here is what they cannot see.
#include <set>

#include "tests/api/door/edr/edr_service_for_tests.h"

namespace slackwater::tests::requirements_encodings_test {
namespace {

using nlohmann::json;

const EdrServiceForTests& service() { return edr_service(); }

const QueryPairs place{{"coords", "POINT(2.41 57.21)"}, {"datetime", "2025-03-10T02:00:00Z"}};
const std::string position = "/collections/currents/position";

QueryPairs with(QueryPairs query, const std::string& key, const std::string& value) {
  query.emplace_back(key, value);
  return query;
}

/// Every kind of resource, with a query that it answers.
std::vector<std::pair<std::string, QueryPairs>> resources() {
  const std::string at = "/collections/currents";
  const std::string instance = at + "/instances/" + EdrServiceForTests::older;
  return {{"/", {}},
          {"/api", {}},
          {"/conformance", {}},
          {"/collections", {}},
          {at, {}},
          {at + "/items", {}},
          {at + "/items/" + EdrServiceForTests::older, {}},
          {at + "/instances", {}},
          {instance, {}},
          {at + "/locations", {}},
          {at + "/locations/farm", {}},
          {position, place}};
}

TEST(EdrJson, EveryResourceIsHadAsJson) {
  for (const auto& [path, query] : resources()) {
    EXPECT_EQ(service().get(path, query, "application/json").media_type, "application/json")
        << path;
    EXPECT_EQ(service().get(path, with(query, "f", "JSON")).media_type, "application/json") << path;
  }
}

TEST(EdrJson, JsonIsWellFormedAndTheSameAsUnderItsOwnName) {
  for (const auto& [path, query] : resources()) {
    const auto answer = service().get(path, query, "application/json");
    EXPECT_TRUE(json::accept(answer.body)) << path;
  }
  EXPECT_EQ(service().get(position, with(place, "f", "JSON")).body,
            service().get(position, with(place, "f", "CoverageJSON")).body);
}

TEST(EdrGeoJson, FeaturesAndDataAreHadAsGeoJson) {
  const std::string at = "/collections/currents";
  EXPECT_EQ(service().get(at + "/items").media_type, "application/geo+json");
  EXPECT_EQ(service().get(at + "/locations").media_type, "application/geo+json");
  EXPECT_EQ(service().get(position, place, "application/geo+json").media_type,
            "application/geo+json");
}

TEST(EdrGeoJson, GeoJsonIsAFeatureCollectionOrAFeatureWithLinks) {
  const std::string at = "/collections/currents";
  const json item = service().document(at + "/items/" + EdrServiceForTests::older);
  EXPECT_EQ(item.at("type"), "Feature");
  for (const json& collection :
       {service().document(at + "/items"), service().document(at + "/locations"),
        service().document(position, with(place, "f", "GeoJSON"))}) {
    EXPECT_EQ(collection.at("type"), "FeatureCollection");
    EXPECT_EQ(links_with(collection, "self"), 1U);
    EXPECT_GE(links_with(collection, "alternate"), 1U);
    for (const json& feature : collection.at("features")) {
      EXPECT_EQ(feature.at("type"), "Feature");
      EXPECT_TRUE(feature.at("geometry").contains("coordinates"));
    }
  }
  EXPECT_EQ(links_with(item, "self"), 1U);
  EXPECT_EQ(links_with(item, "data"), 1U);
}

TEST(EdrGeoJson, TheSelfLinkOfAnAnswerGivesTheAnswer) {
  const auto answer = service().get(position, with(place, "f", "GeoJSON"));
  const json links = json::parse(answer.body).at("links");
  for (const json& link : links) {
    const std::string target = link.at("href").get<std::string>().substr(15);
    const std::size_t mark = target.find('?');
    if (mark == std::string::npos) continue;
    const auto again = service().get_raw(target.substr(0, mark), target.substr(mark + 1));
    EXPECT_EQ(again.status, 200) << target;
    EXPECT_TRUE(again.media_type.starts_with(link.at("type").get<std::string>())) << target;
    if (link.at("rel") == "self") {
      EXPECT_EQ(again.body, answer.body);
    }
  }
}

TEST(EdrEdrGeoJson, FeaturesAndDataAreEdrGeoJson) {
  for (const char* format : {"GeoJSON", "application/geo+json"})
    EXPECT_EQ(service().get(position, with(place, "f", format)).media_type, "application/geo+json");
}

TEST(EdrEdrGeoJson, FeaturesSayWhenWhatAndWhereToAsk) {
  const std::string at = "/collections/currents";
  for (const json& collection :
       {service().document(at + "/items"), service().document(at + "/locations"),
        service().document(position, with(place, "f", "GeoJSON"))}) {
    for (const json& feature : collection.at("features")) {
      const json& properties = feature.at("properties");
      EXPECT_TRUE(properties.at("datetime").is_string());
      EXPECT_TRUE(properties.at("label").is_string());
      EXPECT_FALSE(properties.at("parameter-name").empty());
      EXPECT_TRUE(properties.at("edrqueryendpoint")
                      .get<std::string>()
                      .starts_with(EdrServiceForTests::base));
    }
  }
}

TEST(EdrCoverageJson, DataAreCoverageJsonUnlessAskedOtherwise) {
  EXPECT_EQ(service().get(position, place).media_type, "application/prs.coverage+json");
  EXPECT_EQ(service().get(position, place, "application/prs.coverage+json").media_type,
            "application/prs.coverage+json");
}

TEST(EdrCoverageJson, DomainTypesAreThoseOfTheQueries) {
  const auto domain = [&](QueryPairs query, const char* z, const char* datetime) {
    query = {{"coords", "POINT(2.41 57.21)"}, {"z", z}, {"datetime", datetime}};
    return service().document(position, query).at("domain").at("domainType").get<std::string>();
  };
  EXPECT_EQ(domain({}, "5", "2025-03-10T02:00:00Z"), "Point");
  EXPECT_EQ(domain({}, "5", "2025-03-10T02:00:00Z/.."), "PointSeries");
  EXPECT_EQ(domain({}, "0/20", "2025-03-10T02:00:00Z"), "VerticalProfile");
  EXPECT_EQ(domain({}, "0/20", "2025-03-10T02:00:00Z/.."), "Grid");
}

TEST(EdrCoverageJson, EveryAnswerSaysWhereItComesFrom) {
  const json from = service().document(position, place).at("slackwater:provenance");
  EXPECT_EQ(from.at("instance"), "farm_20250310T050000Z");
  EXPECT_EQ(from.at("attributions"), json({"made up for tests"}));
  EXPECT_EQ(from.at("issued"), "2025-03-10T05:00:00Z");
}

}  // namespace
}  // namespace slackwater::tests::requirements_encodings_test
