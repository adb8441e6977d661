#include "twin/climate/extreme_value.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fields/base/numbers/random.h"

namespace slackwater::twin::extreme_value_test {
namespace {

/// A sample as even as one can be: quantiles at (i - 1/2) / n.
template <typename Quantile>
std::vector<double> even_sample(int n, const Quantile& quantile) {
  std::vector<double> values;
  for (int i = 0; i < n; ++i) values.push_back(quantile((i + 0.5) / n));
  return values;
}

/// Hosking (1990): l2 is half the mean difference of two, l3 a third of the mean second difference
/// of three.
TEST(LinearMomentsOfSamples, AreMeanDifferencesOfAllPairsAndTriples) {
  const std::vector<double> x{4, 1, 9, 2.5, 2.5, 7};
  double pairs = 0;
  double triples = 0;
  int count2 = 0;
  int count3 = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = i + 1; j < x.size(); ++j) {
      pairs += std::abs(x[i] - x[j]);
      ++count2;
      for (std::size_t k = j + 1; k < x.size(); ++k) {
        std::vector<double> three{x[i], x[j], x[k]};
        std::sort(three.begin(), three.end());
        triples += three[2] - 2 * three[1] + three[0];
        ++count3;
      }
    }
  const LinearMoments found = linear_moments(x);
  EXPECT_NEAR(found.l1, 26.0 / 6, 1e-14);
  EXPECT_NEAR(found.l2, pairs / count2 / 2, 1e-14);
  EXPECT_NEAR(found.l3, triples / count3 / 3, 1e-14);
}

/// 1 - P(Y > y) and the quantile undo each other, and meet the exponential at shape 0.
TEST(ParetoOfExcesses, QuantilesUndoTheirProbability) {
  for (const double shape : {-0.4, -0.1, 0.1, 0.4}) {
    const Pareto fit{1.7, shape};
    for (const double survival : {1.0, 0.5, 0.01, 1e-6}) {
      const double y = fit.exceeded_with(survival);
      EXPECT_NEAR(std::pow(1 + shape * y / 1.7, -1 / shape), survival, 1e-12 * survival + 1e-15);
    }
  }
  EXPECT_DOUBLE_EQ((Pareto{2, 0}.exceeded_with(std::exp(-3.0))), 6);
  EXPECT_NEAR((Pareto{2, 1e-7}.exceeded_with(0.01)), (Pareto{2, 0}.exceeded_with(0.01)), 1e-5);
  EXPECT_DOUBLE_EQ((Pareto{2, -0.5}.greatest()), 4);
  EXPECT_TRUE(std::isinf(Pareto{2, 0.1}.greatest()));
}

TEST(ParetoOfExcesses, AFitFindsWhatTheSampleWasDrawnFrom) {
  for (const double shape : {-0.3, -0.1, 0.0, 0.15}) {
    const Pareto truth{1.2, shape};
    const auto fit =
        fitted_pareto(even_sample(20000, [&](double p) { return truth.exceeded_with(1 - p); }));
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->shape, shape, 0.003);
    EXPECT_NEAR(fit->scale, 1.2, 0.004);
  }
}

/// Values between 0 and 1, evenly: shape -1, scale 1, exactly, by the moments 1/2 and 1/6.
TEST(ParetoOfExcesses, OfEvenValuesIsEven) {
  const auto fit = fitted_pareto(even_sample(2000, [](double p) { return p; }));
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->shape, -1, 0.002);
  EXPECT_NEAR(fit->scale, 1, 0.002);
}

/// Other units change the scale alone.
TEST(ParetoOfExcesses, ScalesWithItsUnit) {
  const std::vector<double> metres{0.3, 1.1, 0.2, 2.4, 0.7};
  std::vector<double> centimetres = metres;
  for (double& value : centimetres) value *= 100;
  const auto one = fitted_pareto(metres);
  const auto other = fitted_pareto(centimetres);
  ASSERT_TRUE(one && other);
  EXPECT_NEAR(other->shape, one->shape, 1e-12);
  EXPECT_NEAR(other->scale, 100 * one->scale, 1e-10);
}

TEST(ParetoOfExcesses, OfValuesThatAreAlikeThereIsNone) {
  EXPECT_FALSE(fitted_pareto({0.5, 0.5, 0.5, 0.5}));
  EXPECT_FALSE(fitted_gumbel({2, 2, 2}));
  EXPECT_FALSE(fitted_extreme_value({2, 2, 2}));
}

TEST(ExtremeValueOfMaxima, AFitFindsWhatTheSampleWasDrawnFrom) {
  for (const double shape : {-0.3, -0.1, 0.0, 0.15}) {
    const ExtremeValue truth{6, 0.9, shape};
    const auto values = even_sample(20000, [&](double p) { return truth.not_exceeded_with(p); });
    const auto fit = fitted_extreme_value(values);
    ASSERT_TRUE(fit);
    // The published approximation of k is within 0.0009; the sample ends at its outer quantiles.
    EXPECT_NEAR(fit->shape, shape, 0.004);
    EXPECT_NEAR(fit->scale, 0.9, 0.005);
    EXPECT_NEAR(fit->location, 6, 0.004);
  }
}

/// Location and scale of Gumbel's: mean and half mean difference are known.
TEST(ExtremeValueOfMaxima, GumbelIsThatOfShapeNought) {
  const ExtremeValue truth{6, 0.9, 0};
  const auto fit =
      fitted_gumbel(even_sample(20000, [&](double p) { return truth.not_exceeded_with(p); }));
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->location, 6, 0.001);
  EXPECT_NEAR(fit->scale, 0.9, 0.001);
  EXPECT_EQ(fit->shape, 0);
  EXPECT_DOUBLE_EQ(fit->not_exceeded_with(std::exp(-1)), fit->location);
}

/// Storms that come as a Poisson process with Pareto peaks have maxima of years of the same shape:
/// the value that is exceeded once in T years is the same by both (Coles 2001, section 4.2).
TEST(ExtremeValueOfMaxima, MeetsTheStormsOfWhichTheyAreTheMaxima) {
  for (const double shape : {-0.2, 0.1}) {
    const double rate = 5;
    const double threshold = 4;
    const Pareto storms{0.9, shape};
    // P(no storm above x in a year) = exp(-rate P(Y > x - u)): location and scale follow.
    const double scale = 0.9 * std::pow(rate, shape);
    const ExtremeValue maxima{threshold + (scale - 0.9) / shape, scale, shape};
    for (const double years : {1.0, 10.0, 50.0})
      EXPECT_NEAR(maxima.not_exceeded_with(std::exp(-1 / years)),
                  threshold + storms.exceeded_with(1 / (rate * years)), 1e-12);
  }
}

}  // namespace
}  // namespace slackwater::twin::extreme_value_test
