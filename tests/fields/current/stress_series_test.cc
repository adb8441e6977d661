#include "fields/current/stress_series.h"

#include <gtest/gtest.h>

namespace slackwater::stress_series_test {
namespace {

const UtcTime midnight = parse_utc("2024-03-01T00:00:00Z");
UtcTime at_h(double hours) { return add_hours(midnight, hours); }

VectorColumn wind_at(const std::vector<double>& hours, const std::vector<Horizontal>& wind) {
  VectorColumn column;
  for (std::size_t i = 0; i < hours.size(); ++i) {
    column.time.push_back(TimeCell::instant(at_h(hours[i])));
    column.value.push_back(wind[i]);
    column.status.push_back(SampleStatus::ok);
  }
  return column;
}

TEST(StressSeries, IsLinearBetweenSamplesAndExactOnThem) {
  const StressSeries series(wind_at({0, 2}, {{10, 0}, {0, 10}}), DragLaw::paper_linear);
  const double tau = 0.194775;
  EXPECT_LT(std::abs(*series.at(at_h(0)) - Horizontal(tau, 0)), 1e-15);
  EXPECT_LT(std::abs(*series.at(at_h(0.5)) - Horizontal(0.75 * tau, 0.25 * tau)), 1e-15);
  EXPECT_LT(std::abs(*series.at(at_h(2)) - Horizontal(0, tau)), 1e-15);
}

TEST(StressSeries, TheMeanOverAnIntervalIsTheIntegral) {
  const StressSeries series(wind_at({0, 1, 3, 4}, {{2, 1}, {12, -4}, {-7, 9}, {3, 3}}),
                            DragLaw::paper_linear);
  for (const auto& [from, to] :
       {std::pair{0.0, 4.0}, {0.25, 0.75}, {0.5, 3.5}, {1.0, 3.0}, {-1.0, 0.5}, {3.5, 6.0}}) {
    Horizontal sum{};
    constexpr int n = 7200;
    for (int i = 0; i < n; ++i)
      sum += *series.at(at_h(from + (to - from) * (i + 0.5) / n)) / static_cast<double>(n);
    // Midpoint rule over kinks and times rounded to the millisecond: about 1e-7 of 0.4 Pa.
    EXPECT_LT(std::abs(*series.over({at_h(from), at_h(to)}) - sum), 2e-7) << from << ' ' << to;
  }
  EXPECT_EQ(*series.over(TimeCell::instant(at_h(0.5))), *series.at(at_h(0.5)));
}

TEST(StressSeries, AMeanWindStandsAtTheMiddleOfItsInterval) {
  VectorColumn wind = wind_at({0, 1}, {{10, 0}, {20, 0}});
  wind.time = {{at_h(0), at_h(1)}, {at_h(1), at_h(2)}};
  const StressSeries series(wind, DragLaw::paper_linear);
  EXPECT_NEAR(series.at(at_h(0.5))->real(), 0.194775, 1e-12);
  EXPECT_NEAR(series.at(at_h(1.5))->real(), 1.1711, 1e-12);
}

TEST(StressSeries, AGapIsNoValueRatherThanCalm) {
  const StressSeries series(wind_at({0, 6, 13}, {{10, 0}, {10, 0}, {10, 0}}),
                            DragLaw::paper_linear);
  EXPECT_TRUE(series.at(at_h(3)));  // six hours are the step of the coarsest products
  EXPECT_FALSE(series.at(at_h(9)));
  EXPECT_TRUE(series.at(at_h(13)));
  EXPECT_FALSE(series.over({at_h(5), at_h(14)}));
  EXPECT_FALSE(series.over({at_h(6), at_h(13)}));
  EXPECT_FALSE(series.over({at_h(7), at_h(8)}));
  EXPECT_TRUE(series.over({at_h(1), at_h(6)}));
}

TEST(StressSeries, HoldsThreeHoursBeyondItsEndsAndNoMore) {
  const StressSeries series(wind_at({0, 1}, {{5, 0}, {10, 0}}), DragLaw::paper_linear);
  EXPECT_EQ(series.at(at_h(-3)), series.at(at_h(0)));
  EXPECT_EQ(series.at(at_h(4)), series.at(at_h(1)));
  EXPECT_FALSE(series.at(at_h(-3.01)));
  EXPECT_FALSE(series.at(at_h(4.01)));
  EXPECT_FALSE(series.over({at_h(3), at_h(5)}));
}

TEST(StressSeries, SkipsSamplesWithoutAValue) {
  VectorColumn wind = wind_at({0, 1, 2}, {{10, 0}, {99, 99}, {10, 0}});
  wind.status[1] = SampleStatus::missing;
  EXPECT_NEAR(StressSeries(wind, DragLaw::paper_linear).at(at_h(1))->real(), 0.194775, 1e-12);
  wind.status = {SampleStatus::missing, SampleStatus::missing, SampleStatus::missing};
  EXPECT_TRUE(StressSeries(wind, DragLaw::paper_linear).empty());
  EXPECT_FALSE(StressSeries().at(at_h(1)));
}

}  // namespace
}  // namespace slackwater::stress_series_test
