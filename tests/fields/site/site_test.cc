#include "fields/site/site.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/fields/site/site_for_tests.h"
#include "tests/support/contains.h"
#include "tests/support/error_of.h"

namespace slackwater::tests::site_test {
namespace {

std::string refusal_of(const std::string& yaml) {
  return error_of([&] { return parse_site(yaml, "here.yaml"); });
}

TEST(Site, ValuesOutOfRangeAreRefusedWithTheRange) {
  const auto says = [](const std::string& yaml, const std::vector<std::string>& words) {
    const std::string said = refusal_of("id: a\n" + yaml);
    EXPECT_TRUE(contains(said, "here.yaml"));
    for (const std::string& word : words) EXPECT_TRUE(contains(said, word));
  };
  says("latitude_deg: 95\nlongitude_deg: 6.5\n", {"latitude_deg", "95", "90"});
  says("latitude_deg: 54\nlongitude_deg: 666\n", {"longitude_deg", "666", "360"});
  says("latitude_deg: 54\nlongitude_deg: 6.5\nwater_depth_m: -30\n", {"water_depth_m", "-30"});
  says("latitude_deg: .nan\nlongitude_deg: 6.5\n", {"latitude_deg"});
  says("latitude_deg: 54\nlongitude_deg: .inf\n", {"longitude_deg"});
}

TEST(Site, MissingKeysWrongTypesAndBrokenYamlAreRefused) {
  for (const auto& [yaml, word] : std::vector<std::pair<std::string, std::string>>{
           {"id: a\nlongitude_deg: 6.5\n", "latitude_deg"},
           {"id: a\nlatitude_deg: north\nlongitude_deg: 6.5\n", "north"},
           {"id: a\nlatitude_deg: [54\nlongitude_deg: 6.5\n", ""},
           {"", ""},
           {"- id: a\n", ""},
           {"id: a\nid: b\nlatitude_deg: 54\nlongitude_deg: 6.5\n", "id"},
           {"id: ../../etc/passwd\nlatitude_deg: 54\nlongitude_deg: 6.5\n", "id"}}) {
    EXPECT_TRUE(contains(refusal_of(yaml), "here.yaml"));
    EXPECT_TRUE(contains(refusal_of(yaml), word));
  }
}

TEST(SiteFetch, IsUnknownWhereTheFileSaysNothing) { EXPECT_FALSE(site_with("").fetch); }

TEST(SiteFetch, IsOneNumberOrAListOfSectors) {
  EXPECT_EQ(site_with("fetch_km: 80\n").fetch, Fetch(80e3));
  const Site site = site_with(
      "fetch_km:\n"
      "  - {wind_from_deg: [200, 320], fetch_km: 400}\n"
      "  - {wind_from_deg: [320, 200], fetch_km: 5}\n");
  EXPECT_EQ(site.fetch, Fetch({{200, 320, 400e3}, {320, 200, 5e3}}));
}

TEST(SiteFetch, WhatIsWrongWithItIsSaidWithFileAndLine) {
  EXPECT_TRUE(contains(refusal("fetch_km: 0\n"), "here.yaml:4: fetch_km"))
      << refusal("fetch_km: 0\n");
  EXPECT_TRUE(contains(refusal("fetch_km: far\n"), "fetch_km"));
  const std::string gap = refusal("fetch_km: [{wind_from_deg: [200, 320], fetch_km: 400}]\n");
  EXPECT_TRUE(contains(gap, "here.yaml:4: fetch_km")) << gap;
  EXPECT_TRUE(contains(gap, "found no fetch for wind from 320 to 200 degrees")) << gap;
  EXPECT_TRUE(contains(refusal("fetch_km: [{wind_from_deg: 200, fetch_km: 400}]\n"),
                       "expected two directions"));
  EXPECT_TRUE(contains(refusal("fetch_km: [{fetch_km: 400}]\n"), "expected two directions"));
  EXPECT_TRUE(contains(refusal("fetch_km: [{wind_from_deg: [0, 360]}]\n"), "fetch_km"));
  EXPECT_TRUE(contains(refusal("fetch_km: [{wind_from_deg: [0, 361], fetch_km: 4}]\n"), "361"));
  EXPECT_TRUE(contains(refusal("fetch_km: [{wind_from_deg: [0, 360], fetch_km: 9000}]\n"), "9000"));
  EXPECT_TRUE(
      contains(refusal("fetch_km: [{wind_from: [0, 360], fetch_km: 4}]\n"), "wind_from_deg"));
  EXPECT_NE(refusal("fetch_km: []\n"), "accepted");
  EXPECT_NE(refusal("fetch_km: {wind_from_deg: [0, 360]}\n"), "accepted");
}

}  // namespace
}  // namespace slackwater::tests::site_test
