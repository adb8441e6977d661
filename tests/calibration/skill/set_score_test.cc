#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "calibration/skill/score.h"
#include "fields/base/check.h"

namespace slackwater::calibration::set_score_test {
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

TEST(ScoreSet, FewerThanFivePairsAreFewAndClaimNoInterval) {
  Rng random(2, "set");
  std::vector<VectorScore> pairs;
  for (const double rmse : {0.06, 0.04, 0.047, 0.05}) {
    pairs.push_back(pair_of(rmse, 0.8 + rmse));
    const SetScore few = score_set(pairs, random);
    EXPECT_TRUE(few.is_of_few());
    EXPECT_FALSE(few.rmse_interval) << pairs.size();
    EXPECT_FALSE(few.vector->coverage_interval) << pairs.size();
  }
  pairs.push_back(pair_of(0.045, 0.9));
  const SetScore five = score_set(pairs, random);
  EXPECT_FALSE(five.is_of_few());
  ASSERT_TRUE(five.rmse_interval && five.vector->coverage_interval);
  EXPECT_LT(five.rmse_interval->low, five.rmse);
  EXPECT_GT(five.rmse_interval->high, five.rmse);
}

TEST(ScoreSet, AShareOfTheTruthStaysAShare) {
  Rng random(2, "set");
  std::vector<VectorScore> pairs;
  for (const double inside : {1.0, 1.0, 0.2, 1.0, 1.0, 1.0}) pairs.push_back(pair_of(0.1, inside));
  const SetScore set = score_set(pairs, random);
  EXPECT_GE(set.vector->coverage_interval->low, 0.0);
  EXPECT_LE(set.vector->coverage_interval->high, 1.0);
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
  const std::vector<ScalarScore> heights{{10, 0.3, 0.1, 0.2, {}},
                                         {20, 0.4, -0.2, 0.3, {}},
                                         {20, 0.2, -0.05, 0.3, {}},
                                         {20, 0.5, -0.05, 0.3, {}},
                                         {20, 0.3, -0.05, 0.3, {}}};
  std::vector<VectorScore> vectors(heights.size());
  for (std::size_t i = 0; i < heights.size(); ++i) {
    vectors[i].n = heights[i].n;
    vectors[i].rmse_m_s = heights[i].rmse;
    vectors[i].bias_east_m_s = heights[i].bias;
  }
  const SetScore scalar = score_set(heights, a);
  const SetScore vector = score_set(vectors, b);
  EXPECT_EQ(scalar.rmse, vector.rmse);
  EXPECT_EQ(scalar.n, 90U);
  EXPECT_EQ(scalar.rmse_interval->low, vector.rmse_interval->low);
  EXPECT_DOUBLE_EQ(*scalar.bias, -0.05);
  EXPECT_EQ(*scalar.bias, vector.vector->bias_east_m_s);
  EXPECT_FALSE(scalar.vector);
  EXPECT_FALSE(vector.bias);
}

}  // namespace
}  // namespace slackwater::calibration::set_score_test
