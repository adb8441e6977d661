#include "fields/wave/dispersion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"

namespace slackwater::dispersion_test {
namespace {

using constants::gravity_m_s2;
using constants::pi;

TEST(Wavenumber, IsThatOfThePublishedTable) {
  // fields/docs/physics.md section 8: T, h, k, L, c, cg, n.
  struct Row {
    double period, depth, k, length, speed, group, n;
  };
  for (const Row& row : {Row{5, 30, 0.16104761, 39.01446, 7.80289, 3.90624, 0.500615},
                         Row{8, 30, 0.06543241, 96.02558, 12.00320, 6.93141, 0.577463},
                         Row{10, 50, 0.04154100, 151.25262, 15.12526, 8.54933, 0.565235},
                         Row{12, 30, 0.03549779, 177.00216, 14.75018, 11.16247, 0.756768},
                         Row{15, 20, 0.03181494, 197.49164, 13.16611, 11.67579, 0.886806},
                         Row{8, 1000, 0.06290122, 99.88972, 12.48621, 6.24311, 0.500000}}) {
    const double omega = 2 * pi / row.period;
    const double k = wavenumber_rad_m(omega, row.depth);
    EXPECT_NEAR(k / row.k, 1, 1e-6);
    EXPECT_NEAR(2 * pi / k / row.length, 1, 1e-6);
    EXPECT_NEAR(omega / k / row.speed, 1, 1e-6);
    EXPECT_NEAR(group_speed_m_s(k, row.depth) / row.group, 1, 1e-6);
    EXPECT_NEAR(group_speed_m_s(k, row.depth) * k / omega, row.n, 1e-6);
  }
}

TEST(Wavenumber, SolvesItsEquationToRoundingFromRipplesToTides) {
  Rng rng(1, "dispersion");
  for (int i = 0; i < 5000; ++i) {
    const double omega = std::exp(rng.uniform(std::log(1e-5), std::log(1e3)));
    const double depth = std::exp(rng.uniform(std::log(1e-2), std::log(1e4)));
    const double k = wavenumber_rad_m(omega, depth);
    EXPECT_NEAR(intrinsic_frequency_rad_s(k, depth) / omega, 1, 4e-15) << omega << ' ' << depth;
  }
  EXPECT_EQ(wavenumber_rad_m(0, 10), 0);
}

TEST(Wavenumber, HasTheExactLimitsOfDeepAndShallowWater) {
  EXPECT_DOUBLE_EQ(wavenumber_rad_m(2.0, 1e4), 4.0 / gravity_m_s2);
  EXPECT_NEAR(wavenumber_rad_m(1e-5, 20) * std::sqrt(gravity_m_s2 * 20) / 1e-5, 1, 1e-9);
  EXPECT_DOUBLE_EQ(group_speed_m_s(0.5, 1e4), 0.5 * std::sqrt(gravity_m_s2 / 0.5));
  EXPECT_DOUBLE_EQ(group_speed_m_s(0, 20), std::sqrt(gravity_m_s2 * 20));
}

TEST(GroupSpeed, IsTheSlopeOfTheDispersionRelation) {
  Rng rng(2, "dispersion");
  for (int i = 0; i < 500; ++i) {
    const double depth = std::exp(rng.uniform(std::log(0.5), std::log(500.0)));
    const double k = std::exp(rng.uniform(std::log(1e-3), std::log(3.0)));
    const double step = 1e-5 * k;
    const double slope =
        (intrinsic_frequency_rad_s(k + step, depth) - intrinsic_frequency_rad_s(k - step, depth)) /
        (2 * step);
    EXPECT_NEAR(group_speed_m_s(k, depth) / slope, 1, 1e-8);
  }
}

TEST(WavenumberInCurrent, SolvesTheDopplerShiftedRelationOnTheBranchThatAdvances) {
  Rng rng(3, "dispersion");
  int found = 0;
  for (int i = 0; i < 5000; ++i) {
    const double omega = std::exp(rng.uniform(std::log(0.1), std::log(6.0)));
    const double depth = std::exp(rng.uniform(std::log(2.0), std::log(1000.0)));
    const double current = rng.uniform(-3, 3);
    const auto k = wavenumber_in_current_rad_m(omega, depth, current);
    if (!k) continue;
    ++found;
    EXPECT_NEAR((intrinsic_frequency_rad_s(*k, depth) + *k * current) / omega, 1, 1e-13);
    EXPECT_GT(group_speed_m_s(*k, depth) + current, 0);
    // Against the wave it is shortened, along the wave it is stretched.
    EXPECT_EQ(*k > wavenumber_rad_m(omega, depth), current < 0);
  }
  EXPECT_GT(found, 3000);
}

TEST(WavenumberInCurrent, IsThatOfStillWaterWithoutOne) {
  for (const double omega : {0.01, 0.3, 1.0, 5.0}) {
    for (const double depth : {1.0, 30.0, 3000.0}) {
      EXPECT_NEAR(*wavenumber_in_current_rad_m(omega, depth, 0) / wavenumber_rad_m(omega, depth), 1,
                  1e-14);
    }
  }
}

TEST(WavenumberInCurrent, IsTheClosedFormOfDeepWater) {
  // (omega - k U)^2 = g k: 4 U k = ... by the quadratic formula, the smaller root.
  for (const double current : {-1.5, -0.3, 0.4, 2.0}) {
    const double omega = 0.9;
    const double b = 2 * omega * current + gravity_m_s2;
    const double k =
        (b - std::sqrt(b * b - 4 * current * current * omega * omega)) / (2 * current * current);
    EXPECT_NEAR(*wavenumber_in_current_rad_m(omega, 1e5, current) / k, 1, 1e-12);
  }
}

TEST(WavenumberInCurrent, EndsWhereDeepWaterWavesAreBlocked) {
  // Peregrine (1976): omega |U| = g/4, where k = 4 omega^2/g.
  const double current = -2.0;
  const double limit = 0.25 * gravity_m_s2 / 2.0;
  EXPECT_FALSE(wavenumber_in_current_rad_m(1.0001 * limit, 1e5, current));
  const auto k = wavenumber_in_current_rad_m(0.99999 * limit, 1e5, current);
  ASSERT_TRUE(k);
  EXPECT_NEAR(*k / (4 * limit * limit / gravity_m_s2), 1, 0.02);
  // No wave of any length advances against more than sqrt(g h).
  EXPECT_FALSE(wavenumber_in_current_rad_m(0.1, 2, -5));
}

TEST(Wavenumber, RefusesWhatIsNoWave) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)wavenumber_rad_m(1, 0), ContractViolation);
  EXPECT_THROW((void)wavenumber_rad_m(1, nan), ContractViolation);
  EXPECT_THROW((void)wavenumber_rad_m(-1, 10), ContractViolation);
  EXPECT_THROW((void)wavenumber_rad_m(nan, 10), ContractViolation);
  EXPECT_THROW((void)wavenumber_in_current_rad_m(1, 10, nan), ContractViolation);
}

}  // namespace
}  // namespace slackwater::dispersion_test
