#include "calibration/skill/score.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fields/base/check.h"
#include "fields/base/constants.h"

namespace slackwater::calibration::score_test {
namespace {

std::vector<Horizontal> random_vectors(std::size_t n, std::string_view stream) {
  Rng random(5, stream);
  std::vector<Horizontal> values(n);
  for (Horizontal& value : values) value = {random.normal(), random.normal()};
  return values;
}

TEST(NormalCrps, IsTheIntegralOfTheSquaredDistanceOfDistributions) {
  for (const double sigma : {0.05, 0.7})
    for (const double truth : {-0.3, 0.0, 0.2, 1.5}) {
      // Integral of [Phi((y - mu)/sigma) - 1(y >= truth)]^2 by midpoints, mu = 0.1.
      const double mean = 0.1;
      const double from = std::min(truth, mean) - 10 * sigma;
      const double to = std::max(truth, mean) + 10 * sigma;
      constexpr int n = 200000;
      const double step = (to - from) / n;
      double integral = 0;
      for (int i = 0; i < n; ++i) {
        const double y = from + (i + 0.5) * step;
        const double p =
            0.5 * std::erfc(-(y - mean) / sigma / std::sqrt(2.0)) - (y >= truth ? 1.0 : 0.0);
        integral += p * p * step;
      }
      EXPECT_NEAR(score_of_normal(mean, sigma, truth).crps, integral,
                  1.5 * step);  // half a cell at the jump
    }
  EXPECT_EQ(score_of_normal(0.1, 0.0, 0.4).crps, 0.4 - 0.1);
}

TEST(ScoreVectors, APerfectForecastHasNoError) {
  const auto truth = random_vectors(100, "perfect");
  const std::vector<double> sigma(100, 0.0);
  const VectorScore score = score_vectors(truth, truth, sigma);
  EXPECT_EQ(score.n, 100u);
  EXPECT_EQ(score.rmse_m_s, 0.0);
  EXPECT_EQ(score.speed_bias_m_s, 0.0);
  EXPECT_NEAR(*score.direction_mae_deg, 0.0, 1e-6);
  EXPECT_NEAR(*score.correlation_abs, 1.0, 1e-12);
  EXPECT_NEAR(*score.correlation_deg, 0.0, 1e-9);
  EXPECT_EQ(*score.crps_m_s, 0.0);
  EXPECT_EQ(*score.coverage_80, 1.0);
}

TEST(ScoreVectors, AnOffsetIsBiasAndNothingElse) {
  auto forecast = random_vectors(500, "offset");
  const auto truth = forecast;
  for (Horizontal& value : forecast) value += Horizontal(0.03, -0.04);
  const VectorScore score = score_vectors(forecast, truth);
  EXPECT_NEAR(score.rmse_m_s, 0.05, 1e-12);
  EXPECT_NEAR(score.bias_east_m_s, 0.03, 1e-12);
  EXPECT_NEAR(score.bias_north_m_s, -0.04, 1e-12);
  EXPECT_NEAR(*score.correlation_abs, 1.0, 1e-12);
  EXPECT_FALSE(score.crps_m_s.has_value());
  EXPECT_FALSE(score.coverage_80.has_value());
}

TEST(ScoreVectors, ATurnedCopyCorrelatesFullyAtItsAngle) {
  const auto forecast = random_vectors(200, "turn");
  for (const double angle_deg : {-150.0, -30.0, 75.0}) {
    auto truth = forecast;
    for (Horizontal& value : truth) value *= std::polar(1.7, angle_deg * constants::pi / 180.0);
    const VectorScore score = score_vectors(forecast, truth);
    EXPECT_NEAR(*score.correlation_abs, 1.0, 1e-12);
    EXPECT_NEAR(*score.correlation_deg, angle_deg, 1e-9);  // truth counter-clockwise of forecast
    EXPECT_NEAR(*score.direction_mae_deg, std::abs(angle_deg), 1e-9);
  }
}

TEST(ScoreVectors, DirectionTakesTheSmallestAngleAndSkipsSlackWater) {
  const std::vector<Horizontal> forecast{std::polar(1.0, 3.0), {0.04, 0.0}, {1.0, 0.0}};
  const std::vector<Horizontal> truth{std::polar(1.0, -3.0), {0.0, 1.0}, {0.0, -0.049}};
  EXPECT_NEAR(*score_vectors(forecast, truth).direction_mae_deg,
              (2 * constants::pi - 6.0) * 180.0 / constants::pi, 1e-9);
  const std::vector<Horizontal> calm(3);
  EXPECT_FALSE(score_vectors(forecast, calm).direction_mae_deg.has_value());
}

TEST(ScoreVectors, AConstantForecastHasNoCorrelation) {
  const std::vector<Horizontal> forecast(50, Horizontal(0.1, 0.3));
  const VectorScore score = score_vectors(forecast, random_vectors(50, "constant"));
  EXPECT_FALSE(score.correlation_abs.has_value());
  EXPECT_FALSE(score.correlation_deg.has_value());
}

TEST(ScoreVectors, AHonestSigmaCoversFourFifthsAndHasTheExpectedCrps) {
  constexpr std::size_t n = 40000;
  const auto error = random_vectors(n, "honest");
  const std::vector<Horizontal> forecast(n);
  const std::vector<double> sigma(n, 1.0);
  const VectorScore score = score_vectors(forecast, error, sigma);
  EXPECT_NEAR(*score.coverage_80, 0.8, 4 * std::sqrt(0.16 / (2 * n)));  // four standard errors
  EXPECT_NEAR(*score.crps_m_s, 1.0 / std::sqrt(constants::pi), 4 * 0.41 / std::sqrt(2.0 * n));
}

TEST(ScoreVectors, TurningBothChangesNoScalar) {
  auto forecast = random_vectors(300, "a");
  auto truth = random_vectors(300, "b");
  const VectorScore before = score_vectors(forecast, truth);
  for (Horizontal& value : forecast) value *= std::polar(1.0, 1.1);
  for (Horizontal& value : truth) value *= std::polar(1.0, 1.1);
  const VectorScore after = score_vectors(forecast, truth);
  EXPECT_NEAR(before.rmse_m_s, after.rmse_m_s, 1e-12);
  EXPECT_NEAR(before.speed_bias_m_s, after.speed_bias_m_s, 1e-12);
  EXPECT_NEAR(*before.direction_mae_deg, *after.direction_mae_deg, 1e-9);
  EXPECT_NEAR(*before.correlation_abs, *after.correlation_abs, 1e-12);
}

TEST(ScoreVectors, RefusesNothingAndUnlikeLengths) {
  const std::vector<Horizontal> one(1);
  EXPECT_THROW((void)score_vectors({}, {}), ContractViolation);
  EXPECT_THROW((void)score_vectors(one, {}), ContractViolation);
  EXPECT_THROW((void)score_vectors(one, one, std::vector<double>{-1.0}), ContractViolation);
}

TEST(ScoreScalars, AreThoseOfAWorkedExample) {
  const std::vector<double> forecast{2.0, 3.0, 5.0, 2.0};
  const std::vector<double> truth{1.0, 3.0, 4.0, 4.0};
  // errors 1 0 1 -2: bias 0, mae 1, rmse sqrt(6/4), mean truth 3
  const ScalarScore score = score_scalars(forecast, truth);
  EXPECT_EQ(score.n, 4u);
  EXPECT_DOUBLE_EQ(score.bias, 0.0);
  EXPECT_DOUBLE_EQ(score.mae, 1.0);
  EXPECT_DOUBLE_EQ(score.rmse, std::sqrt(1.5));
  EXPECT_DOUBLE_EQ(*score.scatter_index, std::sqrt(1.5) / 3.0);
  const std::vector<double> calm(4);
  EXPECT_FALSE(score_scalars(forecast, calm).scatter_index.has_value());
}

TEST(RmseOfPairs, WeighsPairsEqually) {
  EXPECT_DOUBLE_EQ(rmse_of_pairs(std::vector<double>{0.3, 0.4}), std::sqrt(0.125));
}

}  // namespace
}  // namespace slackwater::calibration::score_test
