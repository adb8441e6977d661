#include "fields/wave/spreading.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/angle.h"
#include "fields/base/check.h"
#include "fields/base/constants.h"

namespace slackwater::spreading_test {
namespace {

using constants::pi;

/// Integral of D cos(n theta) over all directions; the periodic midpoint rule is exact to rounding
/// where D is smooth at the back, s > 5 or whole.
double moment(double s, int n) {
  constexpr int cells = 4000;
  double sum = 0;
  for (int i = 0; i < cells; ++i) {
    const double theta = -pi + (i + 0.5) * 2 * pi / cells;
    sum += spreading_density(s, theta) * std::cos(n * theta) * 2 * pi / cells;
  }
  return sum;
}

TEST(Spreading, HasThePublishedNorms) {
  // fields/docs/physics.md section 8: D at the mean direction, and the circular spread.
  struct Row {
    double s, norm, spread_deg;
  };
  for (const Row& row : {Row{1, 0.318310, 57.30}, Row{2, 0.424413, 46.78}, Row{5, 0.646725, 33.08},
                         Row{10, 0.903278, 24.43}, Row{25, 1.417544, 15.89}}) {
    EXPECT_NEAR(spreading_density(row.s, 0), row.norm, 1e-6);
    EXPECT_NEAR(Angle::from_radians(circular_spread_rad(row.s)).degrees(), row.spread_deg, 0.005);
  }
}

TEST(Spreading, HoldsAllTheEnergyAndHasItsMoments) {
  for (const double s : {0.0, 1.0, 2.0, 7.3, 25.0, 180.0, 1000.0}) {
    EXPECT_NEAR(moment(s, 0), 1, 1e-11) << s;
    EXPECT_NEAR(moment(s, 1), spreading_first_moment(s), 1e-11) << s;
    EXPECT_NEAR(moment(s, 2), spreading_second_moment(s), 1e-11) << s;
    EXPECT_NEAR(circular_spread_rad(s), std::sqrt(2 * (1 - moment(s, 1))), 1e-8) << s;
  }
}

TEST(Spreading, IsTheHalfAngleForm) {
  // At right angles to the mean cos^2s(theta/2) is 2^-s of the peak; cos^n(theta) would be 0.
  EXPECT_NEAR(spreading_density(3, pi / 2) / spreading_density(3, 0), 1.0 / 8, 1e-12);
  EXPECT_NEAR(spreading_density(3, pi), 0, 1e-15);
  EXPECT_NEAR(spreading_density(0, 2.0), 1 / (2 * pi), 1e-15);
}

TEST(SpreadingQuantile, CutsOffTheShareOfEnergyThatIsAsked) {
  for (const double s : {0.0, 1.0, 10.0, 75.0, 1000.0}) {
    for (const double share : {0.001, 0.1, 0.25, 0.5, 0.9, 0.999}) {
      const double angle = spreading_quantile_rad(s, share);
      constexpr int cells = 20000;
      double below = 0;
      for (int i = 0; i < cells; ++i) {
        const double step = (angle + pi) / cells;
        below += spreading_density(s, -pi + (i + 0.5) * step) * step;
      }
      EXPECT_NEAR(below, share, 1e-3) << s;
      EXPECT_NEAR(angle, -spreading_quantile_rad(s, 1 - share), 1e-9);
    }
    EXPECT_GE(spreading_quantile_rad(s, 0), -pi);
    EXPECT_LE(spreading_quantile_rad(s, 1), pi);
  }
}

TEST(Spreading, RefusesANegativeExponent) {
  EXPECT_THROW((void)spreading_density(-0.1, 0), ContractViolation);
  EXPECT_THROW((void)spreading_first_moment(std::nan("")), ContractViolation);
  EXPECT_THROW((void)spreading_quantile_rad(1, 1.1), ContractViolation);
}

}  // namespace
}  // namespace slackwater::spreading_test
