#include "fields/wind/gust.h"

#include <gtest/gtest.h>

namespace slackwater::gust_test {
namespace {

TEST(Gust, AcrossTheWindIsToItsLeft) {
  // A wind towards north, its left is west.
  const Vector3<Enu> gust = gust_in_enu({1.0, 2.0, -0.5}, {0.0, 8.0});
  EXPECT_NEAR(gust.x(), -2.0, 1e-15);
  EXPECT_NEAR(gust.y(), 1.0, 1e-15);
  EXPECT_EQ(gust.z(), -0.5);
}

TEST(Gust, KeepsItsStrengthInAnyWind) {
  const Gust gust{1.5, -0.7, 0.4};
  for (const Horizontal wind : {Horizontal(3, -4), Horizontal(0, 0), Horizontal(-20, 1)}) {
    EXPECT_NEAR(gust_in_enu(gust, wind).norm(), std::sqrt(2.25 + 0.49 + 0.16), 1e-14);
  }
}

TEST(GustFactor, IsOneInSmoothAir) {
  EXPECT_EQ(gust_factor(0), 1);
  EXPECT_NEAR(gust_factor(0.14, 2.5), 1.35, 1e-15);
}

}  // namespace
}  // namespace slackwater::gust_test
