#include "twin/mission/wave_sector.h"

#include <gtest/gtest.h>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "tests/twin/mission/mission_for_tests.h"
#include "twin/mission/limit.h"

namespace slackwater::tests::wave_sector_test {
namespace {

constexpr double degree = constants::pi / 180;

std::vector<twin::Limit> limits_of(const std::string& limits) {
  return twin::read_limits(Config::parse("limits: [" + limits + "]", "sector.yaml"));
}
twin::WaveSector sector_of(const std::string& more) {
  return limits_of("{significant_wave_height_m: 1.2, " + more + "}").front().waves.value();
}
void expect_refused(const std::string& limits, const std::string& words) {
  try {
    static_cast<void>(limits_of(limits));
    ADD_FAILURE() << limits << " was taken";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

/// Head seas are 0, following ones 180, whatever the heading, and both sides are alike.
TEST(WaveSector, GoesByTheAngleOffTheBowAlone) {
  const twin::WaveSector beam = sector_of("from_bow_deg: [45, 135]");
  for (double heading = -360; heading <= 720; heading += 17)
    for (double off = 0.5; off < 180; ++off)
      for (const double side : {-1.0, 1.0}) {
        const SeaState sea{1, 6, heading + side * off};
        EXPECT_EQ(beam.holds(sea, heading * degree), 45 <= off && off <= 135)
            << heading << " " << side * off;
        EXPECT_EQ(beam.holds({1, 6, sea.from_direction_deg - 720}, heading * degree),
                  beam.holds(sea, heading * degree));
      }
}

TEST(WaveSector, AHeadingOfTheLimitsOwnIsNotTheVehicles) {
  const twin::WaveSector head = sector_of("from_bow_deg: [0, 30], heading_deg: 270");
  for (const double own : {0.0, 1.0, 4.0}) {
    EXPECT_TRUE(head.holds({1, 6, 250}, own));
    EXPECT_FALSE(head.holds({1, 6, 90}, own));
  }
  EXPECT_FALSE(head.goes_by_heading());
}

TEST(WaveSector, PeriodsCountByThemselvesAndBesideTheSector) {
  const twin::WaveSector swell = sector_of("peak_period_between_s: [9, 30]");
  EXPECT_TRUE(swell.holds({1, 9, 0}, 0));
  EXPECT_FALSE(swell.holds({1, 8.9, 0}, 0));
  const twin::WaveSector both = sector_of("from_bow_deg: [0, 30], peak_period_between_s: [9, 30]");
  EXPECT_TRUE(both.holds({1, 10, 20}, 0));
  EXPECT_FALSE(both.holds({1, 8, 20}, 0));
  EXPECT_FALSE(both.holds({1, 10, 40}, 0));
}

/// Waves of which nobody knows the period or the direction may be those of the limit.
TEST(WaveSector, WhatNobodyKnowsIsOfIt) {
  const double unknown = std::nan("");
  const twin::WaveSector both = sector_of("from_bow_deg: [0, 30], peak_period_between_s: [9, 30]");
  EXPECT_TRUE(both.holds({1, unknown, 20}, 0));
  EXPECT_TRUE(both.holds({1, 10, unknown}, 0));
  EXPECT_TRUE(both.holds({1, unknown, unknown}, 0));
  EXPECT_FALSE(both.holds({1, unknown, 40}, 0));
  EXPECT_FALSE(both.holds({1, 8, unknown}, 0));
}

TEST(WaveSector, IsToldWithItsLimit) {
  EXPECT_EQ(text_of(limits_of("{significant_wave_height_m: 1.2, from_bow_deg: [45, 135], "
                              "heading_deg: 210, peak_period_between_s: [7, 30]}")
                        .front()),
            "significant wave height at most 1.2 m from 45 to 135 degrees off the bow (heading "
            "210), peak period 7 to 30 s");
}

TEST(WaveSector, RefusesWhatIsNone) {
  expect_refused("{significant_wave_height_m: 1, from_bow_deg: [135, 45]}", "the lesser first");
  expect_refused("{significant_wave_height_m: 1, from_bow_deg: [45]}", "two numbers");
  expect_refused("{significant_wave_height_m: 1, from_bow_deg: [0, 190]}", "from_bow_deg");
  expect_refused("{significant_wave_height_m: 1, heading_deg: 10}", "without from_bow_deg");
  expect_refused("{current_speed_m_s: 1, from_bow_deg: [0, 90]}", "beside another limit");
  expect_refused("{least_significant_wave_height_m: 1, peak_period_between_s: [5, 9]}",
                 "upper bound");
}

}  // namespace
}  // namespace slackwater::tests::wave_sector_test
