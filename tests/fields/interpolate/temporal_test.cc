#include "fields/interpolate/temporal.h"

#include <gtest/gtest.h>

#include <vector>

namespace slackwater::temporal_test {
namespace {

using std::chrono::hours;
using std::chrono::minutes;

UtcTime at(int h) { return UtcTime(hours(h)); }

TEST(MeanOver, IsTheExactIntegralOfThePiecewiseLinearSeries) {
  const std::vector<UtcTime> stamps{at(0), at(1), at(2), at(3)};
  const std::vector<Horizontal> values{{0, 0}, {1, 2}, {0, 0}, {3, 0}};
  // Over [0.5, 1.5]: two trapezoids from 0.5 to 1 and back.
  const auto mean = mean_over(stamps, values, 1, 0, {at(0) + minutes(30), at(1) + minutes(30)});
  ASSERT_TRUE(mean);
  EXPECT_NEAR(mean->real(), 0.75, 1e-15);
  EXPECT_NEAR(mean->imag(), 1.5, 1e-15);
  EXPECT_NEAR(mean_over(stamps, values, 1, 0, {at(0), at(3)})->real(), (0.5 + 0.5 + 1.5) / 3,
              1e-15);
  EXPECT_EQ(mean_over(stamps, values, 1, 0, TimeCell::instant(at(3)))->real(), 3);
}

TEST(MeanOver, SaysNothingBeyondTheStamps) {
  const std::vector<UtcTime> stamps{at(0), at(1)};
  const std::vector<Horizontal> values{{1, 0}, {1, 0}};
  EXPECT_FALSE(mean_over(stamps, values, 1, 0, {at(0) - minutes(30), at(0) + minutes(30)}));
  EXPECT_FALSE(mean_over(stamps, values, 1, 0, {at(1), at(2)}));
}

TEST(ValueAt, BridgesNarrowGapsOnly) {
  VectorColumn series;
  for (const int h : {0, 1, 8}) {
    series.time.push_back(TimeCell::instant(at(h)));
    series.value.emplace_back(h, 0);
    series.status.push_back(SampleStatus::ok);
    series.source.push_back(DataStatus::analysis);
  }
  EXPECT_NEAR(value_at(series, at(0) + minutes(15), hours(2))->real(), 0.25, 1e-15);
  EXPECT_FALSE(value_at(series, at(4), hours(2)));
  EXPECT_NEAR(value_at(series, at(4), hours(12))->real(), 4, 1e-12);
  EXPECT_FALSE(value_at(series, at(9), hours(12)));
  EXPECT_EQ(value_at(series, at(8), hours(1))->real(), 8);
  series.status[1] = SampleStatus::missing;
  EXPECT_FALSE(value_at(series, at(1), hours(2))) << "a missing value is not a value";
}

}  // namespace
}  // namespace slackwater::temporal_test
