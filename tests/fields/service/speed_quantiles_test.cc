#include "fields/service/speed_quantiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>
#include <vector>

#include "fields/base/constants.h"

namespace slackwater::speed_quantiles_test {
namespace {

TEST(SpeedQuantiles, AboutStillWaterAreThoseOfRayleigh) {
  const SpeedQuantiles q = speed_quantiles(0, 0.2);
  EXPECT_NEAR(q.p10_m_s, 0.2 * std::sqrt(-2 * std::log(0.9)), 4e-5);
  EXPECT_NEAR(q.p50_m_s, 0.2 * std::sqrt(-2 * std::log(0.5)), 4e-5);
  EXPECT_NEAR(q.p90_m_s, 0.2 * std::sqrt(-2 * std::log(0.1)), 4e-5);
}

TEST(SpeedQuantiles, OfAStrongCurrentAreThoseOfANormal) {
  for (const double central : {3.9, 4.1, 50.0}) {  // both sides of where the law changes
    const SpeedQuantiles q = speed_quantiles(central, 0.1);
    const double across = 0.1 * 0.1 / (2 * central);  // what the component across adds
    EXPECT_NEAR(q.p50_m_s, central + across, 1e-4);
    EXPECT_NEAR(q.p90_m_s - q.p50_m_s, 0.1 * constants::normal_p90, 1e-4);
    EXPECT_NEAR(q.p50_m_s - q.p10_m_s, 0.1 * constants::normal_p90, 1e-4);
  }
}

TEST(SpeedQuantiles, AreThoseThatDrawsHave) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  constexpr std::size_t n = 200000;
  for (const double a : {0.3, 1.0, 2.5}) {
    std::vector<double> speed(n);
    for (double& s : speed) s = std::abs(std::complex<double>(a + normal(random), normal(random)));
    std::sort(speed.begin(), speed.end());
    const SpeedQuantiles q = speed_quantiles(a, 1);
    // Four standard errors of a quantile of n draws, density at least 0.15 there.
    const double tolerance = 4 * 0.5 / (0.15 * std::sqrt(static_cast<double>(n)));
    EXPECT_NEAR(q.p10_m_s, speed[n / 10], tolerance) << a;
    EXPECT_NEAR(q.p50_m_s, speed[n / 2], tolerance) << a;
    EXPECT_NEAR(q.p90_m_s, speed[9 * n / 10], tolerance) << a;
  }
}

TEST(SpeedQuantiles, OfAKnownSpeedAreTheSpeed) {
  const SpeedQuantiles q = speed_quantiles(0.7, 0);
  EXPECT_EQ(q.p10_m_s, 0.7);
  EXPECT_EQ(q.p90_m_s, 0.7);
}

}  // namespace
}  // namespace slackwater::speed_quantiles_test
