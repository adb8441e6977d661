#include "calibration/provider/series_at.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/known_series_for_tests.h"

namespace slackwater::calibration::series_at_test {
namespace {

using std::chrono::hours;
using std::chrono::minutes;
using namespace tests;

const UtcTime start = UtcTime(parse_day("2024-06-01"));

Horizontal tide(UtcTime time) {
  return std::polar(0.4, 2 * std::numbers::pi * hours_between(start, time) / 12.4206012);
}

VectorColumn column_of(const std::vector<TimeCell>& cells, const std::vector<double>& depth_m,
                       const FlowForTests& flow) {
  static const Origin origin = analysis_of("model");
  return vector_piece(origin, cells, depth_m, flow).column;
}

/// The tide of a month of hours.
FittedTide fitted(const FlowForTests& flow, const std::vector<double>& depth_m) {
  return fit_column_tide(column_of(instants(start, start + hours(24 * 30)), depth_m, flow),
                         Angle::from_degrees(54));
}

TEST(SeriesAt, IsALineBetweenInstants) {
  const VectorColumn series = column_of(
      instants(start, start + hours(12), hours(3)), {2, 10}, [](UtcTime time, double depth) {
        return Horizontal(0.1 * hours_between(start, time), depth);
      });
  const std::vector<TimeCell> asked{TimeCell::instant(start + hours(4)),
                                    TimeCell::instant(start + hours(12)),
                                    {start + hours(2), start + hours(8)}};
  const std::vector<double> depth_m{2, 6};
  const BaselineForecast made = series_at(series, {}, asked, depth_m);
  const std::vector<Horizontal> expected{{0.4, 2}, {0.4, 6}, {1.2, 2},
                                         {1.2, 6}, {0.5, 2}, {0.5, 6}};
  for (std::size_t o = 0; o < expected.size(); ++o) {
    ASSERT_TRUE(made.has(o)) << o;
    EXPECT_LT(std::abs(made.value[o] - expected[o]), 1e-12) << o;
  }
}

TEST(SeriesAt, GivesItsOwnCellsAsTheyAre) {
  const VectorColumn series = column_of(means(start, start + hours(24)), {2},
                                        [](UtcTime time, double) { return tide(time); });
  const FittedTide other = fitted([](UtcTime time, double) { return 0.5 * tide(time); }, {2});
  const BaselineForecast made =
      series_at(series, {&other, true}, series.time, std::vector<double>{2});
  EXPECT_EQ(made.value, series.value);
}

TEST(SeriesAt, HourlyMeansSpeakToTheirEdges) {
  const VectorColumn series =
      column_of(means(start, start + hours(6)), {2}, steady(Horizontal(0.3, 0)));
  std::vector<TimeCell> asked;
  for (int h = 0; h <= 7; ++h) asked.push_back(TimeCell::instant(start + hours(h)));
  const BaselineForecast made = series_at(series, {}, asked, std::vector<double>{2});
  for (std::size_t h = 0; h < 7; ++h) EXPECT_TRUE(made.has(h)) << h;
  EXPECT_FALSE(made.has(7)) << "an hour after the end";
}

TEST(SeriesAt, SixHourlyInstantsOfATidalSeaAreAsGoodAsHourlyOnes) {
  const FlowForTests sea = [](UtcTime time, double) {
    return tide(time) + Horizontal(0.002 * hours_between(start, time), 0.1);
  };
  const VectorColumn series = column_of(instants(start, start + hours(72), hours(6)), {2}, sea);
  const FittedTide known = fitted([](UtcTime time, double) { return tide(time); }, {2});
  double with = 0;
  double without = 0;
  for (int h = 1; h < 72; ++h) {
    const std::vector<TimeCell> asked{TimeCell::instant(start + hours(h))};
    const std::vector<double> depth_m{2};
    const Horizontal truth = sea(start + hours(h), 2);
    with = std::max(with,
                    std::abs(series_at(series, {&known, true}, asked, depth_m).value[0] - truth));
    without = std::max(without, std::abs(series_at(series, {}, asked, depth_m).value[0] - truth));
  }
  EXPECT_LT(with, 0.002);
  EXPECT_GT(without, 0.3) << "a line through a tide cuts it off";
}

TEST(SeriesAt, TheTideThatASeriesLacksIsAdded) {
  const VectorColumn series =
      column_of(instants(start, start + hours(24), hours(6)), {2}, steady(Horizontal(0.1, 0)));
  const FittedTide known = fitted([](UtcTime time, double) { return tide(time); }, {2});
  const std::vector<TimeCell> asked{TimeCell::instant(start + hours(6)),
                                    TimeCell::instant(start + hours(7))};
  const BaselineForecast made = series_at(series, {&known, false}, asked, std::vector<double>{2});
  for (std::size_t t = 0; t < 2; ++t) {
    EXPECT_LT(std::abs(made.value[t] - tide(asked[t].start) - Horizontal(0.1, 0)), 0.002);
  }
}

TEST(SeriesAt, ADayWithoutValuesIsNoLine) {
  VectorColumn series =
      column_of(instants(start, start + hours(48)), {2}, steady(Horizontal(0.1, 0)));
  for (std::size_t t = 10; t < 34; ++t) series.status[t] = SampleStatus::missing;
  for (std::size_t t = 40; t < 43; ++t) series.status[t] = SampleStatus::missing;
  const std::vector<TimeCell> asked{TimeCell::instant(start + hours(20)),
                                    TimeCell::instant(start + hours(41)),
                                    {start + hours(30), start + hours(36)}};
  const BaselineForecast made = series_at(series, {}, asked, std::vector<double>{2});
  EXPECT_FALSE(made.has(0));
  EXPECT_TRUE(made.has(1)) << "three hours are bridged";
  EXPECT_FALSE(made.has(2)) << "a mean that begins in the gap";
}

TEST(SeriesAt, DailyMeansAreALineBetweenNoons) {
  const VectorColumn series = column_of(
      means(start, start + hours(72), hours(24)), {2},
      [](UtcTime time, double) { return Horizontal(0.01 * hours_between(start, time), 0); });
  const BaselineForecast made =
      series_at(series, {}, std::vector<TimeCell>{TimeCell::instant(start + hours(30))},
                std::vector<double>{2});
  ASSERT_TRUE(made.has(0));
  EXPECT_NEAR(made.value[0].real(), 0.3, 1e-9);
}

TEST(SeriesAt, SpeaksTwoMetresBeyondItsOutermostLevels) {
  const VectorColumn series =
      column_of(instants(start, start + hours(2)), {1, 20}, steady(Horizontal(0.1, 0)));
  const std::vector<double> depth_m{0, 21, 25};
  const BaselineForecast made =
      series_at(series, {}, std::vector<TimeCell>{TimeCell::instant(start)}, depth_m);
  EXPECT_TRUE(made.has(0));
  EXPECT_TRUE(made.has(1));
  EXPECT_FALSE(made.has(2));
}

}  // namespace
}  // namespace slackwater::calibration::series_at_test
