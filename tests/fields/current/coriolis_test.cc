#include "fields/current/coriolis.h"

#include <cmath>

#include <gtest/gtest.h>

namespace slackwater::coriolis_test {
namespace {

TEST(Coriolis, AgreesWithTwiceTheRotationTimesTheSineOfLatitude) {
  // Values computed in double precision from 2 Omega sin(latitude), Omega = 7.292115e-5 rad/s.
  struct Row {
    double latitude_deg, f, inertial_period_h;
  };
  for (const Row& row :
       {Row{43, 9.946420942774e-5, 17.5473093}, Row{54, 1.179888991987e-4, 14.7923174},
        Row{-35, -8.365170670324e-5, 20.8642396}}) {
    const double f = coriolis_parameter_rad_s(Angle::from_degrees(row.latitude_deg));
    EXPECT_NEAR(f, row.f, 1e-15);
    EXPECT_NEAR(2 * constants::pi / std::abs(f) / 3600, row.inertial_period_h, 1e-6);
  }
}

TEST(Coriolis, IsOddInLatitudeAndVanishesOnTheEquator) {
  EXPECT_EQ(coriolis_parameter_rad_s(Angle::from_degrees(0)), 0.0);
  for (double deg = 1; deg <= 90; deg += 7) {
    EXPECT_EQ(coriolis_parameter_rad_s(Angle::from_degrees(-deg)),
              -coriolis_parameter_rad_s(Angle::from_degrees(deg)));
  }
}

TEST(Coriolis, TheEquatorialBandEndsAtThreeDegrees) {
  EXPECT_TRUE(is_equatorial(Angle::from_degrees(0)));
  EXPECT_TRUE(is_equatorial(Angle::from_degrees(2.999)));
  EXPECT_TRUE(is_equatorial(Angle::from_degrees(-2.999)));
  EXPECT_FALSE(is_equatorial(Angle::from_degrees(3.001)));
  EXPECT_FALSE(is_equatorial(Angle::from_degrees(-3.001)));
}

}  // namespace
}  // namespace slackwater::coriolis_test
