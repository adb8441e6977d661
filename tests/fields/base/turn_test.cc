#include "fields/base/turn.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/numbers/random.h"

namespace slackwater::turn_test {
namespace {

using constants::pi;

TEST(Turn, EveryRuleNamesTheSameDirectionInItsRange) {
  Rng rng(5, "turn");
  for (int i = 0; i < 10'000; ++i) {
    const double degrees = rng.uniform(-4000, 4000), radians = degrees * pi / 180;
    const auto is_same_deg = [&](double other) {
      // Eleven turns lose four bits of the rest; fmod and remainder themselves are exact.
      return std::abs(std::remainder(other - degrees, 360.0)) < 1e-12;
    };
    const auto is_same_rad = [&](double other) {
      return std::abs(std::remainder(other - radians, 2 * pi)) < 1e-13;
    };
    const double compass = compass_deg(degrees), way = short_way_deg(degrees);
    EXPECT_TRUE(compass >= 0 && compass < 360 && is_same_deg(compass)) << degrees;
    EXPECT_TRUE(std::abs(way) <= 180 && is_same_deg(way)) << degrees;
    EXPECT_TRUE(compass_rad(radians) >= 0 && compass_rad(radians) < 2 * pi);
    EXPECT_TRUE(is_same_rad(compass_rad(radians)) && is_same_rad(short_way_rad(radians)));
    EXPECT_TRUE(is_same_rad(wrapped_rad(radians)));
    EXPECT_TRUE(wrapped_rad(radians) >= -pi && wrapped_rad(radians) < pi) << radians;
  }
}

TEST(Turn, WhatIsInRangeKeepsItsBits) {
  for (const double degrees : {0.0, 1e-300, 0.1, 179.99999999999997, 359.99999999999994})
    EXPECT_EQ(compass_deg(degrees), degrees);
  for (const double degrees : {-180.0, -0.1, 0.0, 33.3, 180.0})
    EXPECT_EQ(short_way_deg(degrees), degrees);
}

TEST(Turn, TheEndsOfTheRanges) {
  EXPECT_EQ(compass_deg(360), 0);
  EXPECT_EQ(compass_deg(-90), 270);
  // 360 less a hair rounds to 360, which is north.
  EXPECT_EQ(compass_deg(-1e-20), 0);
  EXPECT_EQ(short_way_deg(270), -90);
  EXPECT_EQ(wrapped_rad(pi), -pi);
  EXPECT_TRUE(std::isnan(compass_deg(std::nan(""))));
}

}  // namespace
}  // namespace slackwater::turn_test
