#include "fields/wind/log_profile.h"

#include <gtest/gtest.h>

#include <cmath>

namespace slackwater::log_profile_test {
namespace {

TEST(LogProfile, GivesThePublishedWindAtHubHeight) {
  // fields/docs/physics.md, section 9.
  EXPECT_NEAR(10 * log_profile_ratio(90, 10), 12.030748246, 1e-7);
}

TEST(LogProfile, IsOneAtItsReferenceAndZeroAtTheSea) {
  EXPECT_DOUBLE_EQ(log_profile_ratio(10, 10), 1);
  EXPECT_EQ(log_profile_ratio(open_sea_roughness_m, 10), 0);
  EXPECT_EQ(log_profile_ratio(-3, 10), 0);
  EXPECT_TRUE(std::isnan(log_profile_ratio(std::nan(""), 10)));
}

TEST(LogProfile, ComesBackFromTheBladeTip) {
  for (const double z : {27.0, 90.0, 153.0}) {
    EXPECT_NEAR(log_profile_ratio(z, 10) * log_profile_ratio(10, z), 1, 1e-14);
    // By way of another height: ratios multiply.
    EXPECT_NEAR(log_profile_ratio(z, 10), log_profile_ratio(z, 50) * log_profile_ratio(50, 10),
                1e-14);
  }
}

}  // namespace
}  // namespace slackwater::log_profile_test
