#include "fields/base/numbers/quantile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/base/check.h"
#include "fields/base/numbers/random.h"

namespace slackwater::quantile_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// numpy.quantile([3, 1, 4, 1, 5, 9, 2, 6], [0, 0.1, 0.25, 0.5, 0.9, 1]), numpy 1.24.
TEST(Quantile, IsThatOfNumpy) {
  const std::vector<double> values{3, 1, 4, 1, 5, 9, 2, 6};
  EXPECT_EQ(quantile_of(values, 0), 1);
  EXPECT_DOUBLE_EQ(*quantile_of(values, 0.1), 1);
  EXPECT_DOUBLE_EQ(*quantile_of(values, 0.25), 1.75);
  EXPECT_DOUBLE_EQ(*quantile_of(values, 0.5), 3.5);
  EXPECT_DOUBLE_EQ(*quantile_of(values, 0.9), 6.9);
  EXPECT_EQ(quantile_of(values, 1), 9);
}

TEST(Quantile, CountsOnlyWhatIsFinite) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(quantile_of({nan, 2, infinity, 1, 3, -infinity}, 0.5), 2);
  EXPECT_EQ(quantile_of({nan}, 0.5), std::nullopt);
  EXPECT_EQ(quantile_of({}, 0.5), std::nullopt);
  EXPECT_EQ(quantile_of({7}, 0.9), 7);
}

TEST(Quantile, RulesOfOneNameAgree) {
  Rng rng(4, "quantile");
  for (std::size_t n = 1; n < 120; ++n) {
    std::vector<double> values(n);
    for (double& value : values) value = rng.uniform(-30, 30);
    std::sort(values.begin(), values.end());
    for (const std::size_t percent : {0, 10, 37, 50, 80, 90, 100}) {
      const double share = static_cast<double>(percent) / 100;
      // Two roundings of a place among a hundred, times a step of 60 at most.
      EXPECT_NEAR(percentile(values, percent), *quantile_of(values, share), 1e-12);
      const double nearest = nearest_quantile(values, share);
      EXPECT_TRUE(std::binary_search(values.begin(), values.end(), nearest));
      // It is one of the two between which the other rules lie.
      const PercentilePlace place = percentile_place(n, percent);
      EXPECT_TRUE(nearest == values[place.below] ||
                  nearest == values[std::min(place.below + 1, n - 1)]);
      EXPECT_TRUE(place.hundredths != 0 || percentile(values, percent) == nearest);
    }
  }
}

TEST(Quantile, APercentileOfWholeNumbersIsNotMovedByRounding) {
  // The 90th of 0, 1, ... 10 is 9; 0.9 * 10 in floating point is 9 too, 0.1 * 30 is not 3.
  std::vector<double> steps(31);
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = static_cast<double>(i);
  EXPECT_EQ(percentile(steps, 10), 3);
  EXPECT_EQ(percentile(steps, 90), 27);
}

TEST(Quantile, TheNearestOfTwoAtAHalfIsTheUpperOne) {
  const std::vector<double> two{1, 2};
  EXPECT_EQ(nearest_quantile(two, 0.49), 1);
  EXPECT_EQ(nearest_quantile(two, 0.5), 2);
}

TEST(Quantile, OfNothingIsABugWhereTheValuesAreInOrder) {
  EXPECT_THROW((void)percentile({}, 50), ContractViolation);
  EXPECT_THROW((void)nearest_quantile({}, 0.5), ContractViolation);
}

}  // namespace
}  // namespace slackwater::quantile_test
