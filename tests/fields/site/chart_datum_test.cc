#include "fields/site/chart_datum.h"

#include <gtest/gtest.h>

#include "tests/fields/site/site_for_tests.h"
#include "tests/support/contains.h"

namespace slackwater::tests::chart_datum_test {
namespace {

std::string stated(const std::string& below_m) {
  return "chart_datum: {name: LAT, below_mean_sea_level_m: " + below_m + ", source: chart 1}\n";
}

TEST(ChartDatumOfASite, IsWhatItsFileStatesAndNothingElse) {
  EXPECT_FALSE(site_with("water_depth_m: 30\n").chart_datum);
  EXPECT_EQ(site_with(stated("1.93")).chart_datum, (ChartDatum{"LAT", 1.93, "chart 1"}));
  EXPECT_EQ(site_with(stated("0")).chart_datum->below_mean_sea_level_m, 0)
      << "charts of the Baltic count from mean sea level";
}

TEST(ChartDatumOfASite, LiesBelowMeanSeaLevelSoThatTheSeaIsHigherOverIt) {
  const ChartDatum datum{"LAT", 1.93, "chart 1"};
  EXPECT_DOUBLE_EQ(datum.above_m(0), 1.93);
  EXPECT_DOUBLE_EQ(datum.above_m(-1.93), 0) << "the lowest tide stands at its own datum";
}

TEST(ChartDatumOfASite, WhatCannotBeOneIsRefusedWithItsLine) {
  for (const char* below_m : {".nan", ".inf", "-0.5", "15.1", "193"}) {
    const std::string said = refusal(stated(below_m));
    EXPECT_TRUE(contains(said, "here.yaml:4: chart_datum.below_mean_sea_level_m")) << said;
    EXPECT_TRUE(contains(said, "from 0 to 15")) << said;
  }
  for (const auto& [yaml, word] : {std::pair{"{name: LAT, below_mean_sea_level_m: 2}", "source"},
                                   {"{name: LAT, source: chart 1}", "below_mean_sea_level_m"},
                                   {"{below_mean_sea_level_m: 2, source: chart 1}", "name"},
                                   {"{name: '', below_mean_sea_level_m: 2, source: a}", "name"},
                                   {"{name: LAT, below_mean_sea_level_m: 2, source: ''}", "source"},
                                   {"{name: LAT, below_msl_m: 2, source: a}", "below_mean_sea"},
                                   {"LAT", "a mapping"}}) {
    const std::string said = refusal(std::string("chart_datum: ") + yaml + "\n");
    EXPECT_TRUE(contains(said, word)) << said;
  }
}

TEST(ChartDatumOfASite, SaysBothLevelsOrThatOneIsNotStated) {
  EXPECT_EQ(datum_words(ChartDatum{"LAT", 1.93, "chart 1"}),
            "over mean sea level; chart datum (LAT) is 1.93 m below it");
  EXPECT_EQ(datum_words({}), "over mean sea level; the site states no chart datum");
}

}  // namespace
}  // namespace slackwater::tests::chart_datum_test
