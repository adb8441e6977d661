#include "calibration/skill/bootstrap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "fields/base/check.h"

namespace slackwater::calibration::bootstrap_test {
namespace {

/// A stationary first-order autoregression of unit variance about nought.
std::vector<BlockSum> autoregression(std::size_t n, double phi, Rng& random) {
  std::vector<BlockSum> series;
  double x = random.normal();
  for (std::size_t i = 0; i < n; ++i) {
    series.push_back({x, 1});
    x = phi * x + std::sqrt(1 - phi * phi) * random.normal();
  }
  return series;
}

/// In which share of many draws the interval holds the true mean.
double share_held(std::size_t n, double phi, int experiments) {
  int held = 0;
  for (int i = 0; i < experiments; ++i) {
    Rng random(static_cast<std::uint64_t>(i), "bootstrap/" + std::to_string(n));
    const auto interval = bootstrap_mean(autoregression(n, phi, random), random, 200);
    held += interval->low <= 0 && 0 <= interval->high ? 1 : 0;
  }
  return held / static_cast<double>(experiments);
}

/// The same where members are drawn one by one, as if each day knew nothing of the day before.
double share_held_one_by_one(std::size_t n, double phi, int experiments) {
  int held = 0;
  for (int i = 0; i < experiments; ++i) {
    Rng random(static_cast<std::uint64_t>(i), "one by one");
    const std::vector<BlockSum> series = autoregression(n, phi, random);
    std::vector<double> mean;
    for (int draw = 0; draw < 200; ++draw) {
      double sum = 0;
      for (std::size_t k = 0; k < n; ++k)
        sum += series[static_cast<std::size_t>(random.uniform() * static_cast<double>(n))].sum;
      mean.push_back(sum / static_cast<double>(n));
    }
    std::sort(mean.begin(), mean.end());
    held += mean[5] <= 0 && 0 <= mean[194] ? 1 : 0;
  }
  return held / static_cast<double>(experiments);
}

// 600 experiments: a share of 0.95 is known within 0.018 (two standard errors), one of 0.8 within
// 0.033. The bounds are what the header states, widened by that and a hundredth.
constexpr int experiments = 600;

TEST(BootstrapOfAnAutoregression, HoldsTheMeanOfLongSeriesWhateverTheirMemory) {
  for (const double phi : {0.0, 0.5, 0.8}) {
    for (const std::size_t n : {100U, 200U}) {
      const double share = share_held(n, phi, experiments);
      EXPECT_GT(share, 0.905) << n << " members, phi " << phi;
      EXPECT_LT(share, 0.985) << n << " members, phi " << phi;
    }
  }
}

TEST(BootstrapOfAnAutoregression, DrawingOneByOneHoldsItInHalfTheCases) {
  for (const std::size_t n : {45U, 200U}) {
    EXPECT_LT(share_held_one_by_one(n, 0.5, experiments), 0.80) << n;
    EXPECT_LT(share_held_one_by_one(n, 0.8, experiments), 0.55) << n;
  }
  EXPECT_GT(share_held_one_by_one(200, 0.0, experiments), 0.90) << "the experiment itself is right";
}

/// A short series does not know its own memory; the header says how far it is off.
TEST(BootstrapOfAnAutoregression, OfShortSeriesIsAsGoodAsTheHeaderSays) {
  struct Stated {
    std::size_t n;
    double phi;
    double at_least;
  };
  for (const Stated& s : {Stated{5, 0, 0.92}, Stated{10, 0, 0.93}, Stated{45, 0, 0.92},
                          Stated{5, 0.5, 0.80}, Stated{10, 0.5, 0.85}, Stated{45, 0.5, 0.90},
                          Stated{5, 0.8, 0.66}, Stated{10, 0.8, 0.78}, Stated{45, 0.8, 0.89}}) {
    const double share = share_held(s.n, s.phi, experiments);
    EXPECT_GT(share, s.at_least) << s.n << " members, phi " << s.phi;
    EXPECT_LT(share, 0.985) << s.n << " members, phi " << s.phi;
  }
}

TEST(BlockLength, IsThatOfTheBestCircularBootstrapOfAnAutoregression) {
  EXPECT_EQ(block_length(45, 0), 1U);
  // (sqrt(6) 0.5 / 0.75)^(2/3) = 1.387; 200^(1/3) = 5.848.
  EXPECT_EQ(block_length(200, 0.5), 8U);
  // (sqrt(6) 0.8 / 0.36)^(2/3) = 3.094.
  EXPECT_EQ(block_length(200, 0.8), 18U);
  EXPECT_EQ(block_length(9, 0.8), 3U) << "three blocks at least";
  EXPECT_EQ(block_length(2, 0.8), 1U);
}

TEST(LagOneAutocorrelation, IsThatOfTheSeriesWithoutTheBiasOfAShortOne) {
  for (const double phi : {0.0, 0.5}) {
    double sum = 0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
      Rng random(seed, "lag one");
      sum += lag_one_autocorrelation(autoregression(200, phi, random)) / 400;
    }
    EXPECT_NEAR(sum, phi, phi > 0 ? 0.02 : 0.05) << "nothing below nought";
  }
  std::vector<BlockSum> alternating;
  for (int i = 0; i < 20; ++i) alternating.push_back({i % 2 == 0 ? 1.0 : -1.0, 1});
  EXPECT_EQ(lag_one_autocorrelation(alternating), 0);
  EXPECT_EQ(lag_one_autocorrelation(std::vector<BlockSum>(20, {0.1, 1})), 0) << "a constant";
}

TEST(BootstrapMean, NeedsMembersNotValues) {
  Rng a(5, "x");
  Rng b(5, "x");
  // Doubling every member's values changes neither the mean nor its interval.
  const std::vector<BlockSum> once{{1, 2}, {4, 2}, {3, 2}, {5, 2}, {2, 2}};
  const std::vector<BlockSum> twice{{2, 4}, {8, 4}, {6, 4}, {0, 0}, {10, 4}, {4, 4}};
  EXPECT_DOUBLE_EQ(bootstrap_mean(once, a)->low, bootstrap_mean(twice, b)->low);
  EXPECT_FALSE(bootstrap_mean(std::vector<BlockSum>{{1, 2}, {4, 2}, {3, 2}, {5, 2}, {0, 0}}, a))
      << "four are few";
  EXPECT_THROW((void)bootstrap_mean(once, a, 39), ContractViolation);
}

TEST(BootstrapMean, OfAConstantIsThatConstant) {
  Rng random(6, "x");
  const auto interval = bootstrap_mean(std::vector<BlockSum>(8, {0.3, 1}), random);
  EXPECT_NEAR(interval->low, 0.3, 1e-12);
  EXPECT_NEAR(interval->high, 0.3, 1e-12);
}

TEST(BootstrapRmse, CoversTheTruthNineteenTimesInTwenty) {
  // 200 experiments of 40 blocks of 10 fully dependent errors with true RMSE 1.
  int covered = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Rng random(seed, "bootstrap");
    std::vector<double> squares;
    std::vector<std::size_t> block;
    for (std::size_t b = 0; b < 40; ++b) {
      const double error = random.normal();
      for (int i = 0; i < 10; ++i) squares.push_back(error * error), block.push_back(b);
    }
    const auto interval = bootstrap_rmse(squares, block, random, 400);
    ASSERT_TRUE(interval.has_value());
    EXPECT_LT(interval->low, interval->high);
    covered += interval->low <= 1.0 && 1.0 <= interval->high ? 1 : 0;
  }
  // Of 40 skewed squares about 93 %; treating values as independent covers half.
  EXPECT_GT(covered, 170);
  EXPECT_LT(covered, 199);
}

TEST(BootstrapRmse, IsTheSameForTheSameSeedAndEmptyForOneBlock) {
  const std::vector<double> squares{1, 2, 3, 4, 2, 5, 3};
  const std::vector<std::size_t> block{7, 7, 9, 9, 10, 12, 13};
  Rng a(1, "x");
  Rng b(1, "x");
  EXPECT_EQ(bootstrap_rmse(squares, block, a)->high, bootstrap_rmse(squares, block, b)->high);
  const std::vector<std::size_t> lone(7, 3);
  EXPECT_FALSE(bootstrap_rmse(squares, lone, a).has_value());
}

}  // namespace
}  // namespace slackwater::calibration::bootstrap_test
