#include "fields/site/farm.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/error.h"
#include "fields/base/numbers/random.h"
#include "fields/site/site.h"
#include "tests/fields/site/site_for_tests.h"
#include "tests/support/shared_data.h"

namespace slackwater::tests::farm_test {
namespace {

const std::string two_turbines =
    "turbines:\n  - {id: A, latitude_deg: 54, longitude_deg: 6.5}\n"
    "  - {id: B, latitude_deg: 54.01, longitude_deg: 6.5, landing_deg: 90, foundation: {kind: "
    "floating, diameter_m: 12, draught_m: 20, top_height_m: 15}, moorings: [{id: M1, bearing_deg: "
    "0, anchor_distance_m: 250, fairlead_depth_m: 14}]}\n";

TEST(Farm, WhatStandsBesideTheTurbinesIsOfThoseThatSayNothingElse) {
  const Site site = site_with(
      "landing_deg: 180\nhub_height_m: 90\nfoundation: {kind: monopile, diameter_m: 6, "
      "top_height_m: 20}\n" +
      two_turbines);
  ASSERT_EQ(site.turbines.size(), 2U);
  EXPECT_EQ(site.turbines[0].foundation->kind, FoundationKind::monopile);
  EXPECT_EQ(site.turbines[0].landing_deg, 180);
  EXPECT_EQ(site.turbines[1].foundation->kind, FoundationKind::floating);
  EXPECT_EQ(site.turbines[1].landing_deg, 90);
  EXPECT_EQ(site.turbines[1].hub_height_m, 90);
  EXPECT_EQ(site.turbines[1].moorings.size(), 1U);
}

TEST(Farm, TheExampleIsRead) {
  const Site site = find_site("example_farm", {source_folder() / "data" / "sites"});
  EXPECT_EQ(site.turbines.size(), 5U);
  EXPECT_EQ(site.cables.size(), 1U);
  EXPECT_EQ(site.cables[0].route.size(), 3U);
  EXPECT_EQ(site.areas.size(), 2U);
}

TEST(Farm, RefusesWhatDoesNotFitTogether) {
  const auto says = [](const std::string& more, const std::string& words) {
    const std::string text = refusal(more);
    EXPECT_NE(text.find(words), std::string::npos) << more << "\n-> " << text;
  };
  says(
      "turbines: [{id: A, latitude_deg: 54, longitude_deg: 6}, {id: A, latitude_deg: 54, "
      "longitude_deg: 6.1}]\n",
      "A twice");
  says("foundation: {kind: tripod, top_height_m: 20}\n" + two_turbines, "expected monopile");
  says("foundation: {kind: monopile, diameter_m: 6, draught_m: 3, top_height_m: 20}\n" +
           two_turbines,
       "draught_m");
  says(
      "turbines: [{id: A, latitude_deg: 54, longitude_deg: 6, moorings: [{id: M, bearing_deg: 0, "
      "anchor_distance_m: 100, fairlead_depth_m: 3}]}]\n",
      "does not float");
  says("hub_height_m: 15\nfoundation: {kind: monopile, diameter_m: 6, top_height_m: 20}\n" +
           two_turbines,
       "not above");
  says(two_turbines + "cables: [{id: C, from: A, to: Z}]\n", "no turbine of this site");
  says(two_turbines + "cables: [{id: C, from: A}]\n", "two ends");
  says(
      "areas: [{id: z, kind: exclusion, polygon: [{latitude_deg: 54, longitude_deg: 6}, "
      "{latitude_deg: 55, longitude_deg: 6}]}]\n",
      "three and more");
  says(
      "areas: [{id: z, kind: exclusion, polygon: [{latitude_deg: 54, longitude_deg: 6}, "
      "{latitude_deg: 55, longitude_deg: 7}, {latitude_deg: 55, longitude_deg: 6}, "
      "{latitude_deg: 54, longitude_deg: 7}]}]\n",
      "cross");
  says("areas: [{id: z, kind: park, polygon: []}]\n", "expected exclusion");
}

ConstraintArea in_force(std::optional<Span> months, std::optional<Span> hours) {
  ConstraintArea area;
  area.months = months;
  area.hours_utc = hours;
  return area;
}

TEST(ConstraintArea, IsInForceInItsMonthsAndHoursOverTheEndOfYearAndDay) {
  const auto at = [](const char* text) { return parse_utc(text); };
  const ConstraintArea summer = in_force(Span{4, 7}, Span{3, 20});
  EXPECT_TRUE(summer.is_in_force(at("2025-04-01T03:00:00Z")));
  EXPECT_TRUE(summer.is_in_force(at("2025-07-31T20:59:59Z")));
  EXPECT_FALSE(summer.is_in_force(at("2025-07-31T21:00:00Z")));
  EXPECT_FALSE(summer.is_in_force(at("2025-08-01T12:00:00Z")));
  const ConstraintArea winter = in_force(Span{11, 2}, Span{22, 4});
  EXPECT_TRUE(winter.is_in_force(at("2025-12-31T23:30:00Z")));
  EXPECT_TRUE(winter.is_in_force(at("2025-02-28T04:59:00Z")));
  EXPECT_FALSE(winter.is_in_force(at("2025-03-01T00:00:00Z")));
  EXPECT_FALSE(winter.is_in_force(at("2025-01-01T12:00:00Z")));
  EXPECT_TRUE(in_force({}, {}).is_in_force(at("2025-06-01T12:00:00Z")));
}

TEST(ConstraintArea, IsInsideAsOftenAsItWindsRoundAPlace) {
  // Stars of any number of points about the origin, against the sum of the angles seen.
  Rng rng(3, "areas");
  for (int i = 0; i < 300; ++i) {
    std::vector<Horizontal> corners;
    const int n = 3 + static_cast<int>(rng.uniform(0, 9));
    for (int k = 0; k < n; ++k)
      corners.push_back(std::polar(rng.uniform(20, 100), 2 * 3.141592653589793 * k / n));
    for (int j = 0; j < 30; ++j) {
      const Horizontal place(rng.uniform(-110, 110), rng.uniform(-110, 110));
      double wound = 0;
      for (std::size_t k = 0; k < corners.size(); ++k)
        wound += std::arg((corners[(k + 1) % corners.size()] - place) / (corners[k] - place));
      EXPECT_EQ(is_inside(corners, place), std::abs(wound) > 3) << i << " " << place;
    }
  }
}

TEST(ConstraintArea, AWayLeadsThroughWhereOneOfItsPlacesLies) {
  Rng rng(4, "areas");
  const std::vector<Horizontal> corners{{0, 0}, {60, 10}, {40, 50}, {20, 20}, {-10, 40}};
  for (int i = 0; i < 2000; ++i) {
    const Horizontal from(rng.uniform(-60, 100), rng.uniform(-60, 100));
    const Horizontal to(rng.uniform(-60, 100), rng.uniform(-60, 100));
    bool touches = false;
    for (int k = 0; k <= 2000; ++k)
      touches = touches || is_inside(corners, from + (k / 2000.0) * (to - from));
    // What the steps miss is a corner grazed.
    if (touches) {
      EXPECT_TRUE(leads_through(corners, from, to)) << i;
    }
    if (!leads_through(corners, from, to)) {
      EXPECT_FALSE(touches) << i;
    }
  }
}

}  // namespace
}  // namespace slackwater::tests::farm_test
