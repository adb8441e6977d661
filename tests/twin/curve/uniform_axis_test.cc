#include "twin/curve/uniform_axis.h"

#include <gtest/gtest.h>

#include <limits>

namespace slackwater::twin::uniform_axis_test {
namespace {

const std::vector<double> uneven{0, 0.05, 0.1, 0.3, 1};

TEST(UniformAxis, IsTheCoarsestThatHoldsAllPoints) {
  const auto axis = uniform_axis_through(uneven, 501);
  ASSERT_TRUE(axis);
  EXPECT_EQ(axis->count, 21U);
  EXPECT_NEAR(axis->step, 0.05, 1e-15);
  const std::vector<double> volts{10, 12, 16, 20};
  EXPECT_EQ(uniform_axis_through(volts, 501)->count, 6U);
}

TEST(UniformAxis, IsNoneForPointsWithoutACommonStep) {
  const std::vector<double> odd{0, 0.333333, 0.5, 1};
  EXPECT_FALSE(uniform_axis_through(odd, 501));
}

TEST(UniformAxis, ATableOnItIsTheBrokenLineItself) {
  const std::vector<double> y{1, 3, -2, 5, 4};
  const UniformAxis axis = *uniform_axis_through(uneven, 501);
  const std::vector<double> table = on_axis(axis, uneven, y);
  const auto value = [&](double x) { return on_line(table.data(), place_on(axis, x)).value; };
  for (std::size_t i = 0; i < uneven.size(); ++i) EXPECT_NEAR(value(uneven[i]), y[i], 1e-12);
  EXPECT_NEAR(value(0.025), 2, 1e-12);
  EXPECT_NEAR(value(0.22), -2 + 7 * 0.6, 1e-12);
  EXPECT_NEAR(value(0.65), 4.5, 1e-12);
}

TEST(UniformAxis, BeyondItsEndsAndForNoNumberTheTableHoldsItsEnd) {
  const UniformAxis axis{-1, 0.5, 5};
  const double table[] = {3, 1, 4, 1, 6};
  const auto value = [&](double x) { return on_line(table, place_on(axis, x)).value; };
  constexpr double huge = std::numeric_limits<double>::infinity();
  EXPECT_EQ(value(-7), 3);
  EXPECT_EQ(value(-huge), 3);
  EXPECT_EQ(value(1), 6);
  EXPECT_EQ(value(1e300), 6);
  EXPECT_EQ(value(huge), 6);
  EXPECT_EQ(value(std::numeric_limits<double>::quiet_NaN()), 3);
}

}  // namespace
}  // namespace slackwater::twin::uniform_axis_test
