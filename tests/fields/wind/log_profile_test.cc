#include "fields/wind/log_profile.h"

#include <gtest/gtest.h>

#include <cmath>

namespace slackwater {
namespace {

TEST(WindProfile, GivesThePublishedWindAtHubHeight) {
  // fields/docs/physics.md, section 9.
  EXPECT_NEAR(10 * log_profile_ratio(90, 10), 12.030748246, 1e-7);
  EXPECT_NEAR(10 * power_profile_ratio(90, 10), 13.601723788, 1e-7);
  EXPECT_NEAR(10 * power_profile_ratio(90, 10, 0.11), 12.734053673, 1e-7);
  EXPECT_NEAR(neutral_drag_coefficient(open_sea_roughness_m), 1.3667e-3, 5e-8);
}

TEST(WindProfile, IsOneAtItsReferenceAndZeroAtTheSea) {
  for (const WindProfile profile :
       {WindProfile{}, WindProfile{WindProfile::Law::power, offshore_shear_exponent}}) {
    EXPECT_DOUBLE_EQ(profile.ratio(10, 10), 1);
    EXPECT_EQ(profile.ratio(0, 10), 0);
    EXPECT_EQ(profile.ratio(-3, 10), 0);
    EXPECT_TRUE(std::isnan(profile.ratio(std::nan(""), 10)));
  }
  EXPECT_EQ(log_profile_ratio(open_sea_roughness_m, 10), 0);
}

TEST(WindProfile, ComesBackFromTheBladeTip) {
  for (const WindProfile profile : {WindProfile{}, WindProfile{WindProfile::Law::power, 0.11}})
    for (const double z : {27.0, 90.0, 153.0}) {
      const Horizontal at_10{-7.0, 4.0};
      const Horizontal back = profile.at(profile.at(at_10, z), 10.0, z);
      EXPECT_NEAR(std::abs(back - at_10), 0, 1e-14);
      // By way of another height: ratios multiply.
      EXPECT_NEAR(profile.ratio(z, 10), profile.ratio(z, 50) * profile.ratio(50, 10), 1e-14);
    }
}

TEST(WindProfile, IsFoundAgainFromTwoHeights) {
  EXPECT_NEAR(shear_exponent_between(10, 8, 90, 8 * power_profile_ratio(90, 10, 0.14)), 0.14,
              1e-14);
  EXPECT_NEAR(roughness_between(10, 8, 90, 8 * log_profile_ratio(90, 10, 0.003)), 0.003, 1e-13);
  EXPECT_TRUE(std::isnan(roughness_between(10, 8, 90, 8)));
}

TEST(WindProfile, KeepsTheDirectionOfTheWind) {
  const Horizontal wind = vector_from_direction(9, 240);
  EXPECT_NEAR(from_direction_deg(WindProfile{}.at(wind, 90)), 240, 1e-10);
}

}  // namespace
}  // namespace slackwater
