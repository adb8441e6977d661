// Requirements class "core" of OGC API-EDR 1.1: landing page, definition,
// conformance, bbox and datetime.
#include <algorithm>
#include <set>

#include "tests/api/door/edr/edr_service_for_tests.h"

namespace slackwater::tests::requirements_core_test {
namespace {

using nlohmann::json;

const EdrServiceForTests& service() { return edr_service(); }

std::string href_of(const json& document, const std::string& relation) {
  for (const json& link : document.at("links"))
    if (link.at("rel") == relation) return link.at("href");
  ADD_FAILURE() << "no link " << relation;
  return {};
}

/// The path behind the base address.
std::string path_of(const std::string& href) {
  const std::string base = EdrServiceForTests::base;
  EXPECT_TRUE(href.starts_with(base)) << href;
  return href.substr(base.size());
}

std::set<std::string> ids_of(const json& features) {
  std::set<std::string> ids;
  for (const json& feature : features.at("features")) ids.insert(feature.at("id"));
  return ids;
}

TEST(EdrCore, TheLandingPageIsAtTheRoot) {
  EXPECT_EQ(service().get("/").status, 200);
  EXPECT_EQ(service().get("/").media_type, "application/json");
}

TEST(EdrCore, TheLandingPageLeadsToDefinitionConformanceAndCollections) {
  const json page = service().document("/");
  EXPECT_TRUE(page.at("title").is_string());
  for (const char* relation : {"self", "service-desc", "service-doc", "conformance", "data"})
    EXPECT_GE(links_with(page, relation), 1U) << relation;
  EXPECT_EQ(path_of(href_of(page, "conformance")), "/conformance");
  EXPECT_EQ(path_of(href_of(page, "data")), "/collections");
}

TEST(EdrCore, TheDefinitionIsWhereTheLandingPageSays) {
  const json page = service().document("/");
  EXPECT_EQ(service().get(path_of(href_of(page, "service-desc"))).status, 200);
}

TEST(EdrCore, TheDefinitionHasTheMediaTypeOfItsLink) {
  const json page = service().document("/");
  for (const json& link : page.at("links")) {
    if (link.at("rel") != "service-desc") continue;
    EXPECT_EQ(service().get(path_of(link.at("href"))).media_type, link.at("type"));
  }
}

TEST(EdrCore, TheConformanceDeclarationIsAtItsPath) {
  EXPECT_EQ(service().get("/conformance").status, 200);
}

TEST(EdrCore, TheConformanceDeclarationListsCoreAndItsDependencies) {
  const json all = service().document("/conformance").at("conformsTo");
  for (const char* name : {"http://www.opengis.net/spec/ogcapi-edr-1/1.1/conf/core",
                           "http://www.opengis.net/spec/ogcapi-edr-1/1.1/conf/collections",
                           "http://www.opengis.net/spec/ogcapi-common-1/1.0/conf/core",
                           "http://www.opengis.net/spec/ogcapi-common-2/1.0/conf/collections"})
    EXPECT_NE(std::find(all.begin(), all.end(), name), all.end()) << name;
}

TEST(EdrCore, BboxIsFourOrSixNumbersInTheDefinition) {
  const json bbox = service().document("/api").at("components").at("parameters").at("bbox");
  EXPECT_EQ(bbox.at("style"), "form");
  EXPECT_EQ(bbox.at("explode"), false);
  std::set<int> lengths;
  for (const json& form : bbox.at("schema").at("oneOf")) {
    EXPECT_EQ(form.at("items").at("type"), "number");
    EXPECT_EQ(form.at("minItems"), form.at("maxItems"));
    lengths.insert(form.at("minItems").get<int>());
  }
  EXPECT_EQ(lengths, (std::set<int>{4, 6}));
}

TEST(EdrCore, ABoxSelectsTheFeaturesThatMeetIt) {
  const std::string locations = "/collections/currents/locations";
  EXPECT_EQ(service().document(locations).at("numberMatched"), 15);
  EXPECT_EQ(ids_of(service().document(locations, {{"bbox", "-3,48,-2,49"}})),
            (std::set<std::string>{"lone"}));
  // The two columns nearest to the corner of the grid: 2.40 and 2.42 E at 57.20 N.
  EXPECT_EQ(ids_of(service().document(locations, {{"bbox", "2.39,57.19,2.43,57.21"}})),
            (std::set<std::string>{"farm", "farm.1"}));
  EXPECT_EQ(ids_of(service().document(locations, {{"bbox", "179,-18,-179,-16"}})),
            (std::set<std::string>{"dateline", "dateline.1"}));
  EXPECT_EQ(ids_of(service().document(locations, {{"bbox", "10,0,20,5"}})),
            std::set<std::string>{});
  // Six numbers: the levels say nothing of places at the surface.
  EXPECT_EQ(ids_of(service().document(locations, {{"bbox", "-3,48,0,-2,49,10"}})),
            (std::set<std::string>{"lone"}));
  EXPECT_EQ(ids_of(service().document("/collections/waves/items", {{"bbox", "-3,48,-2,49"}})),
            (std::set<std::string>{EdrServiceForTests::older, EdrServiceForTests::newer}));
}

TEST(EdrCore, DatetimeIsTextInTheDefinition) {
  const json datetime = service().document("/api").at("components").at("parameters").at("datetime");
  EXPECT_EQ(datetime.at("in"), "query");
  EXPECT_EQ(datetime.at("required"), false);
  EXPECT_EQ(datetime.at("schema").at("type"), "string");
  EXPECT_EQ(datetime.at("explode"), false);
}

TEST(EdrCore, DatetimeSelectsInstantsClosedAndOpenIntervals) {
  const std::string at = "/collections/currents/position";
  const auto times = [&](const std::string& datetime) {
    const json body =
        service().document(at, {{"coords", "POINT(2.4 57.2)"}, {"z", "5"}, {"datetime", datetime}});
    return body.at("domain").at("axes").at("t").at("values");
  };
  EXPECT_EQ(times("2025-03-10T03:00:00Z"), json({"2025-03-10T03:00:00Z"}));
  EXPECT_EQ(times("2025-03-10T04:00:00+01:00"), json({"2025-03-10T03:00:00Z"}));
  EXPECT_EQ(times("2025-03-10T03:00:00Z/2025-03-10T04:00:00Z"),
            json({"2025-03-10T03:00:00Z", "2025-03-10T04:00:00Z"}));
  EXPECT_EQ(times("../2025-03-10T01:30:00Z"),
            json({"2025-03-10T00:00:00Z", "2025-03-10T01:00:00Z"}));
  EXPECT_EQ(times("2025-03-10T11:00:00Z/.."),
            json({"2025-03-10T11:00:00Z", "2025-03-10T12:00:00Z"}));
  const std::string items = "/collections/currents/items";
  EXPECT_EQ(ids_of(service().document(items, {{"datetime", "2025-03-11T06:00:00Z"}})),
            (std::set<std::string>{EdrServiceForTests::newer}));
  EXPECT_EQ(ids_of(service().document(items, {{"datetime", "../2025-03-09T00:00:00Z"}})),
            std::set<std::string>{});
}

TEST(EdrCore, RefusalsAreHttpStatusesWithProblemDocuments) {
  EXPECT_FALSE(service().refusal(404, "/nowhere").empty());
  EXPECT_FALSE(service().refusal(404, "/collections/soup").empty());
  EXPECT_FALSE(service().refusal(400, "/collections/currents/position").empty());
}

TEST(EdrCore, GeometriesAreLongitudeThenLatitudeUnlessAsked) {
  const json here =
      service().document("/collections/waves/locations", {{"bbox", "2.39,57.19,2.41,57.21"}});
  EXPECT_NEAR(here.at("features")[0].at("geometry").at("coordinates")[0].get<double>(), 2.40, 1e-9);
  EXPECT_NEAR(here.at("features")[0].at("geometry").at("coordinates")[1].get<double>(), 57.20,
              1e-9);
  const json body =
      service().document("/collections/waves/position", {{"coords", "POINT(2.4 57.2)"}});
  EXPECT_EQ(body.at("domain").at("referencing")[0].at("system").at("id"),
            "http://www.opengis.net/def/crs/OGC/1.3/CRS84");
  EXPECT_EQ(body.at("domain").at("axes").at("x").at("values"), json({2.4}));
}

TEST(EdrFeatures, PagesFollowEachOtherUntilAllWereSeen) {
  std::set<std::string> seen;
  std::string next = "/collections/currents/locations?limit=4";
  for (int pages = 0; !next.empty(); ++pages) {
    ASSERT_LT(pages, 5);
    const std::size_t mark = next.find('?');
    const auto answer = service().get_raw(next.substr(0, mark), next.substr(mark + 1));
    ASSERT_EQ(answer.status, 200) << next;
    const json page = json::parse(answer.body);
    EXPECT_LE(page.at("numberReturned").get<int>(), 4);
    for (const std::string& id : ids_of(page)) EXPECT_TRUE(seen.insert(id).second) << id;
    next = links_with(page, "next") > 0 ? path_of(href_of(page, "next")) : "";
  }
  EXPECT_EQ(seen.size(), 15U);
}

}  // namespace
}  // namespace slackwater::tests::requirements_core_test
