// Two farms in one bay: which of them answers when none is named.
#include "api/door/edr/sample/site_choice.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/api/door/edr/edr_service_for_tests.h"
#include "tests/support/made_up_forecast.h"

namespace slackwater::api::edr::site_choice_test {
namespace {

/// A site with a grid of columns from a south-western corner.
ForecastCatalogue::SiteForecast site(const std::string& id, double west_deg, double south_deg,
                                     std::size_t rows, std::size_t columns, double step_deg) {
  tests::MadeUpForecast size;
  size.columns = rows * columns;
  size.hours = 6;
  size.members = 2;
  Snapshot made = tests::made_up_forecast(size);
  made.site_id = id;
  for (std::size_t c = 0; c < made.columns.size(); ++c) {
    made.columns[c].point =
        GeoPoint::from_degrees(south_deg + step_deg * static_cast<double>(c / columns),
                               west_deg + step_deg * static_cast<double>(c % columns));
  }
  return {
      id, id + "_now", std::make_shared<const Field>(std::make_shared<const Snapshot>(made)), {}};
}

/// "wide" is 38 columns over 0.36 by 0.02 degrees; "lone" one column amid them, whose name and
/// place come first wherever places are compared by a site's first column.
ForecastCatalogue two_sites() {
  ForecastCatalogue catalogue;
  catalogue.sites = {site("lone", 2.16, 57.01, 1, 1, 0.02), site("wide", 2.0, 57.0, 2, 19, 0.02)};
  return catalogue;
}

SiteChoice choice(const ForecastCatalogue& catalogue, const std::string& type,
                  const std::string& query) {
  for (const QueryType& known : query_types())
    if (known.name == type) return site_for(catalogue, known, QueryString::parse(query));
  ADD_FAILURE() << "no query type " << type;
  return {};
}

std::string answering(const ForecastCatalogue& catalogue, const std::string& type,
                      const std::string& query) {
  const SiteChoice found = choice(catalogue, type, query);
  return found.site == nullptr ? "none" : found.site->site_id;
}

TEST(SiteChoice, AnAreaIsAnsweredByTheSiteThatReachesMostOfIt) {
  const ForecastCatalogue catalogue = two_sites();
  EXPECT_EQ(answering(catalogue, "area",
                      "coords=POLYGON((1.99 56.99,2.37 56.99,2.37 57.03,1.99 57.03,1.99 56.99))"),
            "wide");
  EXPECT_EQ(answering(catalogue, "cube", "bbox=2.0,57.0,2.36,57.02"), "wide");
  EXPECT_EQ(answering(catalogue, "radius", "coords=POINT(2.16 57.01)&within=8&within-units=km"),
            "wide");
}

TEST(SiteChoice, OfSitesThatReachAllOfAnAreaTheOneWithTheMostColumnsInItAnswers) {
  const ForecastCatalogue catalogue = two_sites();
  EXPECT_EQ(answering(catalogue, "cube", "bbox=2.13,57.0,2.19,57.02"), "wide");
  EXPECT_EQ(answering(catalogue, "area",
                      "coords=POLYGON((2.13 57.0,2.19 57.0,2.19 57.02,2.13 57.02,2.13 57.0))"),
            "wide");
  // Between the columns of the wide site lies the lone one's.
  EXPECT_EQ(answering(catalogue, "cube", "bbox=2.155,57.005,2.165,57.015"), "lone");
}

TEST(SiteChoice, APlaceIsAnsweredByTheSiteWithTheNearestColumn) {
  const ForecastCatalogue catalogue = two_sites();
  EXPECT_EQ(answering(catalogue, "position", "coords=POINT(2.16 57.011)"), "lone");
  EXPECT_EQ(answering(catalogue, "position", "coords=POINT(2.181 57.019)"), "wide");
  EXPECT_EQ(answering(catalogue, "position", "coords=POINT(2.34 57.01)"), "wide");
  EXPECT_EQ(answering(catalogue, "position", "coords=MULTIPOINT((2.16 57.01),(2.34 57.01))"),
            "wide")
      << "the lone site does not reach both";
}

TEST(SiteChoice, ALineIsAnsweredByTheSiteThatReachesMostOfIt) {
  const ForecastCatalogue catalogue = two_sites();
  EXPECT_EQ(answering(catalogue, "trajectory", "coords=LINESTRING(2.16 57.01,2.34 57.01)"), "wide");
}

TEST(SiteChoice, TheOrderInWhichSitesStandDecidesNothing) {
  ForecastCatalogue catalogue = two_sites();
  std::swap(catalogue.sites[0], catalogue.sites[1]);
  EXPECT_EQ(answering(catalogue, "cube", "bbox=2.13,57.0,2.19,57.02"), "wide");
  EXPECT_EQ(answering(catalogue, "position", "coords=POINT(2.16 57.011)"), "lone");
}

TEST(SiteChoice, AcrossTheAntimeridianTheWiderSiteAnswersToo) {
  ForecastCatalogue catalogue;
  catalogue.sites = {site("lone", 179.99, -17, 1, 1, 0.02),
                     site("wide", 179.9, -17.01, 2, 11, 0.02)};
  EXPECT_EQ(answering(catalogue, "cube", "bbox=179.91,-17.01,-179.91,-16.99"), "wide");
}

TEST(SiteChoice, AnAreaFarLargerThanAnySiteIsAnsweredByTheLargest) {
  EXPECT_EQ(answering(two_sites(), "cube", "bbox=-20,30,40,70"), "wide");
}

TEST(SiteChoice, WhatNoSiteReachesIsNobodys) {
  EXPECT_EQ(answering(two_sites(), "cube", "bbox=20,57,21,58"), "none");
  EXPECT_EQ(answering(two_sites(), "position", "coords=POINT(20 57)"), "none");
}

TEST(SiteChoice, TheAnswerSaysWhichSiteAnswersAndWhichOthersReach) {
  const SiteChoice found = choice(two_sites(), "cube", "bbox=2.13,57.0,2.19,57.02");
  ASSERT_EQ(found.notes.size(), 1U);
  EXPECT_NE(found.notes[0].find("answered by site wide"), std::string::npos) << found.notes[0];
  EXPECT_NE(found.notes[0].find("lone reaches"), std::string::npos) << found.notes[0];
  ForecastCatalogue alone = two_sites();
  alone.sites.erase(alone.sites.begin());
  EXPECT_TRUE(choice(alone, "cube", "bbox=2.13,57.0,2.19,57.02").notes.empty());
}

TEST(SiteChoice, OverHttpAnAreaIsAnsweredByTheFarmAndNotByTheLoneColumnAmidIt) {
  tests::EdrServiceForTests service;
  Snapshot amid = tests::lone_forecast(0, 41);
  amid.site_id = "amid";
  amid.columns.front().point = GeoPoint::from_degrees(57.221, 2.431);
  service.issue(amid);
  const tests::QueryPairs query{{"bbox", "2.39,57.19,2.47,57.25"}, {"z", "0"}};
  const auto from =
      service.document("/collections/currents/cube", query).at("slackwater:provenance");
  EXPECT_EQ(from.at("site"), "farm");
  EXPECT_NE(from.at("notes").dump().find("amid reaches"), std::string::npos) << from;
  const auto named =
      service.document("/collections/currents/locations/amid").at("slackwater:provenance");
  EXPECT_EQ(named.at("site"), "amid") << "who names a site is answered by it";
}

TEST(SiteChoice, ADamagedNewerForecastIsNamedInTheAnswer) {
  ForecastCatalogue catalogue = two_sites();
  catalogue.sites[1].passed_over = {"wide_later"};
  const SiteChoice found = choice(catalogue, "position", "coords=POINT(2.34 57.01)");
  ASSERT_FALSE(found.notes.empty());
  EXPECT_NE(found.notes[0].find("wide_later is damaged"), std::string::npos) << found.notes[0];
}

}  // namespace
}  // namespace slackwater::api::edr::site_choice_test
