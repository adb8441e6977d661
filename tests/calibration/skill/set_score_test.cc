#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "calibration/skill/score.h"
#include "fields/base/check.h"

namespace slackwater::calibration {
namespace {

VectorScore pair_of(double rmse, double coverage, std::size_t n = 100) {
  VectorScore score;
  score.n = n;
  score.rmse_m_s = rmse;
  score.bias_east_m_s = rmse / 2;
  score.coverage_80 = coverage;
  score.crps_m_s = rmse / 3;
  return score;
}

TEST(ScoreSet, WeighsPairsEquallyWhateverTheirSize) {
  Rng random(1, "set");
  const SetScore set =
      score_set(std::vector<VectorScore>{pair_of(0.3, 0.7, 10), pair_of(0.4, 0.9, 100000)}, random);
  EXPECT_EQ(set.pairs, 2U);
  EXPECT_EQ(set.n, 100010U);
  EXPECT_DOUBLE_EQ(set.rmse, std::sqrt(0.125));
  EXPECT_DOUBLE_EQ(*set.vector->coverage_80, 0.8);
  EXPECT_DOUBLE_EQ(set.vector->bias_east_m_s, 0.175);
}

TEST(ScoreSet, TheIntervalOfAFewPairsSpansThem) {
  Rng random(2, "set");
  const SetScore set = score_set(
      std::vector<VectorScore>{pair_of(0.06, 0.70), pair_of(0.04, 0.95), pair_of(0.047, 0.78)},
      random);
  // All three draws fall on one pair with probability 1/27 = 3.7 %: more than either tail.
  EXPECT_DOUBLE_EQ(set.rmse_interval->low, 0.04);
  EXPECT_DOUBLE_EQ(set.rmse_interval->high, 0.06);
  EXPECT_DOUBLE_EQ(set.vector->coverage_interval->low, 0.70);
  EXPECT_DOUBLE_EQ(set.vector->coverage_interval->high, 0.95);
}

TEST(ScoreSet, TheIntervalOfManyPairsShrinksWithTheirNumber) {
  const auto width = [](std::size_t pairs) {
    Rng random(3, "set of many");
    std::vector<VectorScore> scores;
    for (std::size_t i = 0; i < pairs; ++i) scores.push_back(pair_of(0.1, random.uniform()));
    const SetScore set = score_set(scores, random);
    return set.vector->coverage_interval->high - set.vector->coverage_interval->low;
  };
  // Mean of uniforms: 2 * 1.96 / sqrt(12 n), within a quarter.
  EXPECT_NEAR(width(50), 3.92 / std::sqrt(600.0), 0.25 * 3.92 / std::sqrt(600.0));
  EXPECT_NEAR(width(800), 3.92 / std::sqrt(9600.0), 0.25 * 3.92 / std::sqrt(9600.0));
}

TEST(ScoreSet, ASinglePairHasNoIntervalAndNoPairsAreABug) {
  Rng random(4, "set");
  const SetScore set = score_set(std::vector<VectorScore>{pair_of(0.1, 0.8)}, random);
  EXPECT_FALSE(set.rmse_interval);
  EXPECT_FALSE(set.vector->coverage_interval);
  EXPECT_THROW((void)score_set(std::vector<VectorScore>{}, random), ContractViolation);
}

TEST(ScoreSet, OfScalarsIsThatOfVectorsOfOneComponentInItsOwnUnit) {
  Rng a(6, "set");
  Rng b(6, "set");
  const std::vector<ScalarScore> heights{{10, 0.3, 0.1, 0.2, {}}, {20, 0.4, -0.2, 0.3, {}}};
  std::vector<VectorScore> vectors(2);
  for (std::size_t i = 0; i < 2; ++i) {
    vectors[i].n = heights[i].n;
    vectors[i].rmse_m_s = heights[i].rmse;
    vectors[i].bias_east_m_s = heights[i].bias;
  }
  const SetScore scalar = score_set(heights, a);
  const SetScore vector = score_set(vectors, b);
  EXPECT_EQ(scalar.rmse, vector.rmse);
  EXPECT_EQ(scalar.n, 30U);
  EXPECT_EQ(scalar.rmse_interval->low, vector.rmse_interval->low);
  EXPECT_DOUBLE_EQ(*scalar.bias, -0.05);
  EXPECT_EQ(*scalar.bias, vector.vector->bias_east_m_s);
  EXPECT_FALSE(scalar.vector);
  EXPECT_FALSE(vector.bias);
}

TEST(BootstrapMean, NeedsBlocksNotValues) {
  Rng a(5, "x");
  Rng b(5, "x");
  // Doubling every block's values changes neither the mean nor its interval.
  const std::vector<BlockSum> once{{1, 2}, {4, 2}, {3, 2}};
  const std::vector<BlockSum> twice{{2, 4}, {8, 4}, {6, 4}, {0, 0}};
  EXPECT_DOUBLE_EQ(bootstrap_mean(once, a)->low, bootstrap_mean(twice, b)->low);
  EXPECT_FALSE(bootstrap_mean(std::vector<BlockSum>{{1, 2}, {0, 0}}, a));
}

}  // namespace
}  // namespace slackwater::calibration
