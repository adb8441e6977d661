#include "fields/base/numbers/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "fields/base/check.h"
#include "fields/base/numbers/random.h"

namespace slackwater::statistics_test {
namespace {

TEST(Median, OfAnOddNumberIsTheOneInTheMiddleWhateverItsName) {
  EXPECT_EQ(median({3, 9, 1}), 3);
  EXPECT_EQ(upper_median<int>({3, 9, 1}), 3);
  EXPECT_EQ(lower_median<int>({3, 9, 1}), 3);
  EXPECT_EQ(median({7}), 7);
}

TEST(Median, OfAnEvenNumberIsWhatItsNameSays) {
  EXPECT_EQ(median({4, 1, 9, 2}), 3);
  EXPECT_EQ(upper_median<int>({4, 1, 9, 2}), 4);
  EXPECT_EQ(lower_median<int>({4, 1, 9, 2}), 2);
}

TEST(Median, StandsInTheMiddleOfTheSortedValues) {
  Rng rng(3, "median");
  for (std::size_t n = 1; n < 60; ++n) {
    std::vector<double> values(n);
    // Some alike, some below nought.
    for (double& value : values) value = static_cast<double>(rng.bits() % 20) - 10;
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(upper_median(values), sorted[n / 2]);
    EXPECT_EQ(lower_median(values), sorted[(n - 1) / 2]);
    EXPECT_EQ(median(values), 0.5 * (sorted[(n - 1) / 2] + sorted[n / 2]));
  }
}

TEST(Median, OfNothingIsABug) {
  EXPECT_THROW((void)median({}), ContractViolation);
  EXPECT_THROW((void)upper_median<int>({}), ContractViolation);
  EXPECT_THROW((void)lower_median<int>({}), ContractViolation);
}

}  // namespace
}  // namespace slackwater::statistics_test
