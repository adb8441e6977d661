#include "twin/inspection/defect/hit_miss_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/numbers/random.h"

namespace slackwater::twin::hit_miss_fit_test {
namespace {

std::vector<HitMiss> of_size(double size, int hits, int misses) {
  std::vector<HitMiss> looks;
  for (int i = 0; i < hits + misses; ++i) looks.push_back({size, i < hits});
  return looks;
}

/// Looks at defects of 5 to 500 mm, found by a curve.
std::vector<HitMiss> looks_by(const LogLogisticPod& truth, std::size_t many, std::uint64_t seed) {
  Rng rng(seed, "hit and miss");
  std::vector<HitMiss> looks;
  for (std::size_t i = 0; i < many; ++i) {
    const double size = 0.005 * std::pow(100.0, rng.uniform());
    looks.push_back({size, rng.uniform() < pod_of(truth, size)});
  }
  return looks;
}

TEST(HitMissFit, OfTwoSizesGoesThroughBothShares) {
  std::vector<HitMiss> looks = of_size(0.01, 3, 9);
  const std::vector<HitMiss> larger = of_size(0.1, 16, 4);
  looks.insert(looks.end(), larger.begin(), larger.end());
  const auto fit = fit_hit_miss(looks);
  ASSERT_TRUE(fit.has_value());
  // Two numbers for two shares: the greatest likelihood has both.
  EXPECT_NEAR(pod_of(fit->curve, 0.01), 3.0 / 12, 1e-9);
  EXPECT_NEAR(pod_of(fit->curve, 0.1), 16.0 / 20, 1e-9);
  EXPECT_EQ(fit->looks, 32U);
  EXPECT_EQ(fit->hits, 19U);
  // The information of a share p of n looks is n p (1 - p): the logits' variances are its inverse.
  const double var_1 = 1 / (12 * 0.25 * 0.75), var_2 = 1 / (20 * 0.8 * 0.2);
  const double sd_b = std::sqrt(var_1 + var_2) / std::log(10.0);
  EXPECT_NEAR(fit->b.high - fit->b.value, 1.959964 * sd_b, 1e-5);
}

TEST(HitMissFit, FindsNineOfTenAtA90) {
  const auto fit = fit_hit_miss(looks_by({0.05, 2}, 3000, 1));
  ASSERT_TRUE(fit.has_value());
  EXPECT_NEAR(pod_of(fit->curve, fit->a90.value), 0.9, 1e-12);
  EXPECT_NEAR(pod_of(fit->curve, fit->x0.value), 0.5, 1e-12);
  EXPECT_NEAR(fit->curve.x0, 0.05, 0.004);
  EXPECT_NEAR(fit->curve.b, 2, 0.2);
}

TEST(HitMissFit, RangesHoldTheTruthInNineteenOfTwentyTrials) {
  const LogLogisticPod truth{0.06, 1.7};
  const double a90 = truth.x0 * std::pow(9.0, 1 / truth.b);
  int x0 = 0, b = 0, of_90 = 0;
  constexpr int trials = 400;
  for (int trial = 0; trial < trials; ++trial) {
    const auto fit = fit_hit_miss(looks_by(truth, 300, 100 + static_cast<std::uint64_t>(trial)));
    ASSERT_TRUE(fit.has_value());
    x0 += fit->x0.low <= truth.x0 && truth.x0 <= fit->x0.high ? 1 : 0;
    b += fit->b.low <= truth.b && truth.b <= fit->b.high ? 1 : 0;
    of_90 += fit->a90.low <= a90 && a90 <= fit->a90.high ? 1 : 0;
  }
  // 380 expected, 4.4 the standard deviation of the count: four of them.
  EXPECT_NEAR(x0, 380, 18);
  EXPECT_NEAR(b, 380, 18);
  EXPECT_NEAR(of_90, 380, 18);
}

TEST(HitMissFit, SaysNothingWhereNoCurveRises) {
  EXPECT_FALSE(fit_hit_miss({}).has_value());
  EXPECT_FALSE(fit_hit_miss(of_size(0.1, 10, 0)).has_value());
  EXPECT_FALSE(fit_hit_miss(of_size(0.1, 0, 10)).has_value());
  // Parted at one size: the steeper, the likelier, without end.
  std::vector<HitMiss> parted = of_size(0.01, 0, 5);
  const std::vector<HitMiss> larger = of_size(0.1, 5, 0);
  parted.insert(parted.end(), larger.begin(), larger.end());
  EXPECT_FALSE(fit_hit_miss(parted).has_value());
  // The larger, the less found.
  std::vector<HitMiss> falling = of_size(0.01, 9, 1);
  const std::vector<HitMiss> worse = of_size(0.1, 1, 9);
  falling.insert(falling.end(), worse.begin(), worse.end());
  EXPECT_FALSE(fit_hit_miss(falling).has_value());
}

}  // namespace
}  // namespace slackwater::twin::hit_miss_fit_test
