#include "calibration/blend/weighted_mean.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fields/base/numbers/random.h"

namespace slackwater::calibration::weighted_mean_test {
namespace {

TEST(WeightedMean, EqualWeightsGiveTheStandardErrorOfTheTextbook) {
  const std::vector<double> x{1.0, 4.0, 2.0, 3.0};  // neighbours are anticorrelated: r = 0
  const std::vector<double> g(4, 0.3);
  const WeightedMean mean = weighted_mean(x, g);
  EXPECT_NEAR(mean.mean, 2.5, 1e-15);
  EXPECT_NEAR(mean.independent, 4.0, 1e-12);
  EXPECT_NEAR(mean.standard_error, std::sqrt(5.0 / 3.0 / 4.0), 1e-12);
}

TEST(WeightedMean, OneLuckyDayIsOneStandardErrorHoweverLucky) {
  for (const double luck : {1.0, 1e3, 1e9}) {
    std::vector<double> x(20, 0.0);
    x[13] = luck;
    const WeightedMean mean = weighted_mean(x, std::vector<double>(20, 1.0));
    EXPECT_NEAR(mean.mean / mean.standard_error, 1.0, 1e-12);
  }
}

TEST(WeightedMean, CorrelatedTermsAreWorthFewer) {
  Rng random(3, "ar1");
  std::vector<double> x(20000);
  double state = 0;
  for (double& value : x) {
    state = 0.5 * state + std::sqrt(0.75) * random.normal();
    value = state;
  }
  const WeightedMean mean = weighted_mean(x, std::vector<double>(x.size(), 1.0));
  // (1 - r)/(1 + r) = 1/3; the estimate of r is good to 0.01.
  EXPECT_NEAR(mean.independent / 20000.0, 1.0 / 3.0, 0.02);
}

TEST(WeightedMean, ForgettingMakesFewOfMany) {
  std::vector<double> x(400);
  std::vector<double> g(400);
  Rng random(4, "forget");
  for (std::size_t i = 0; i < 400; ++i) {
    x[i] = random.normal();
    g[i] = std::exp(-static_cast<double>(400 - i) / 14.0);
  }
  // (sum g)^2 / sum g^2 of an exponential of 14 days is 28, less where r > 0.
  EXPECT_LE(weighted_mean(x, g).independent, 28.1);
  EXPECT_GE(weighted_mean(x, g).independent, 10.0);
}

TEST(WeightedMean, OneTermSaysNothingOfItsError) {
  const WeightedMean mean = weighted_mean(std::vector<double>{2.0}, std::vector<double>{1.0});
  EXPECT_EQ(mean.mean, 2.0);
  EXPECT_TRUE(std::isinf(mean.standard_error));
}

}  // namespace
}  // namespace slackwater::calibration::weighted_mean_test
