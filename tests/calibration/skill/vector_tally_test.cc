#include "calibration/skill/vector_tally.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "calibration/skill/score.h"
#include "fields/base/check.h"

namespace slackwater::calibration::vector_tally_test {
namespace {

TEST(ScoreOfNormal, AsksTheNormalDistribution) {
  // Phi(-1.2815516) = 0.1, Phi(1.6448536) = 0.95: tables of the standard normal.
  EXPECT_NEAR(score_of_normal(2.0, 0.5, 2.0 - 0.5 * 1.2815515655).probability_below, 0.1, 1e-9);
  EXPECT_NEAR(score_of_normal(2.0, 0.5, 2.0 + 0.5 * 1.6448536270).probability_below, 0.95, 1e-9);
  EXPECT_EQ(score_of_normal(1.0, 0.0, 1.5).probability_below, 1.0);
  EXPECT_EQ(score_of_normal(1.0, 0.0, 0.5).probability_below, 0.0);
  EXPECT_EQ(score_of_normal(1.0, 0.0, 1.0).probability_below, 0.5);
}

PairContribution random_pair(Rng& random, double bias, double sigma_of_error, double sigma_said) {
  const Horizontal truth(0.3 + 0.2 * random.normal(), 0.2 * random.normal());
  const Horizontal error(bias + sigma_of_error * random.normal(), sigma_of_error * random.normal());
  return contribution_of(truth + error, truth, sigma_said);
}

TEST(VectorTally, MergedPartsAreTheWhole) {
  Rng random(3, "tally");
  VectorTally whole;
  VectorTally first;
  VectorTally second;
  for (int i = 0; i < 500; ++i) {
    const PairContribution pair = random_pair(random, 0.02, 0.1, 0.1);
    whole.add(pair);
    (i < 123 ? first : second).add(pair);
  }
  first.merge(second);
  const VectorScore a = whole.score();
  const VectorScore b = first.score();
  EXPECT_EQ(a.n, b.n);
  // Sums of 500 values in another order: rounding.
  EXPECT_NEAR(a.rmse_m_s, b.rmse_m_s, 1e-13);
  EXPECT_NEAR(a.bias_east_m_s, b.bias_east_m_s, 1e-13);
  EXPECT_NEAR(*a.direction_mae_deg, *b.direction_mae_deg, 1e-10);
  EXPECT_NEAR(*a.correlation_abs, *b.correlation_abs, 1e-12);
  EXPECT_NEAR(*a.crps_m_s, *b.crps_m_s, 1e-13);
  EXPECT_EQ(a.reliability->pit, b.reliability->pit);
}

TEST(VectorTally, AnHonestSpreadIsReliableAtEveryQuantile) {
  Rng random(4, "honest");
  VectorTally tally;
  constexpr int n = 20000;
  for (int i = 0; i < n; ++i) tally.add(random_pair(random, 0, 0.1, 0.1));
  const VectorScore score = tally.score();
  ASSERT_TRUE(score.reliability);
  for (std::size_t i = 0; i < Reliability::probability.size(); ++i) {
    const double p = Reliability::probability[i];
    // Four standard errors of a share among 2 n components.
    EXPECT_NEAR(score.reliability->below[i], p, 4 * std::sqrt(p * (1 - p) / (2 * n)));
  }
  double sum = 0;
  for (const double share : score.reliability->pit) {
    EXPECT_NEAR(share, 0.1, 4 * std::sqrt(0.09 / (2 * n)));
    sum += share;
  }
  EXPECT_NEAR(sum, 1.0, 1e-12);
  EXPECT_NEAR(*score.coverage_80, score.reliability->below[5] - score.reliability->below[1], 1e-12);
}

TEST(VectorTally, ATooWideSpreadPilesTheTruthInTheMiddleAndABiasToOneSide) {
  Rng random(5, "dishonest");
  VectorTally wide;
  VectorTally high;
  for (int i = 0; i < 5000; ++i) {
    wide.add(random_pair(random, 0, 0.1, 0.3));
    const Horizontal truth(0.1 * random.normal(), 0.1 * random.normal());
    high.add(contribution_of(truth + Horizontal(0.1, 0.1), truth, 0.1));
  }
  const Reliability hump = *wide.score().reliability;
  EXPECT_GT(hump.pit[4], 2.0 * 0.1);
  EXPECT_LT(hump.pit[0], 0.2 * 0.1);
  // A forecast that says too much finds the truth below its quantiles too often.
  EXPECT_GT(high.score().reliability->below[3], 0.6);
}

TEST(VectorTally, SpreadsOfSomePairsOnlyAreNotScored) {
  VectorTally tally;
  tally.add(contribution_of({0.1, 0.2}, {0.2, 0.1}, 0.1));
  tally.add(contribution_of({0.1, 0.2}, {0.2, 0.1}));
  EXPECT_FALSE(tally.score().crps_m_s);
  EXPECT_FALSE(tally.score().reliability);
  EXPECT_THROW((void)VectorTally{}.score(), ContractViolation);
}

}  // namespace
}  // namespace slackwater::calibration::vector_tally_test
