// The truth of a past forecast, laid out as one that erred nowhere.
#include "calibration/verify/what_came.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/known_series_for_tests.h"

namespace slackwater::calibration::what_came_test {
namespace {

using std::chrono::days;
using std::chrono::hours;

const UtcTime end_of_day = UtcTime(parse_day("2024-06-11")) + days(1);
constexpr std::size_t stamps = 49;
const std::vector<double> depths{2, 10};

// Lines in time and depth: what is between values is known to the last bit or nearly.
Horizontal current_at(UtcTime time, double depth_m) {
  return {0.01 * hours_between(end_of_day, time), 0.02 * depth_m};
}
Horizontal wind_at(UtcTime time) { return {5 + 0.1 * hours_between(end_of_day, time), -3}; }
double height_at(UtcTime time) { return 1 + 0.02 * hours_between(end_of_day, time); }

/// A forecast that is wrong everywhere.
Snapshot forecast() {
  Snapshot made;
  made.day = parse_day("2024-06-11");
  made.issued = end_of_day + hours(5);
  made.depth_m = depths;
  made.members = 3;
  ForecastColumn& column = made.columns.emplace_back();
  column.point = GeoPoint::from_degrees(54, 6.5);
  column.water_depth_m = 30;
  for (std::size_t t = 0; t < stamps; ++t) {
    made.time.push_back(end_of_day + hours(t));
    column.wind_m_s.emplace_back(20, 20);
    column.wind_source.push_back(DataStatus::forecast);
    column.sea.push_back({9, 15, 90});
    column.sea_source.push_back(DataStatus::forecast);
    column.height_spread.push_back(0.2);
    for (std::size_t k = 0; k < depths.size(); ++k) {
      column.current_m_s.emplace_back(3, 3);
      column.current_sigma_m_s.push_back(0.1);
      column.current_status.push_back(SampleStatus::ok);
    }
  }
  for (const std::size_t size : {column.current_m_s.size()})
    column.member_m_s.assign(2 * size, {4, 4});
  column.wind_member_m_s.assign(2 * stamps, {30, 0});
  return made;
}

/// All that came, hourly, until a time.
tests::KnownSeriesForTests sea(UtcTime until) {
  tests::KnownSeriesForTests made;
  const auto cells = tests::instants(end_of_day - hours(24), until);
  made.current(tests::analysis_of("model"), cells, depths, current_at);
  made.wind(tests::analysis_of("wind"), cells, [](UtcTime t, double) { return wind_at(t); });
  made.waves(
      tests::analysis_of("waves"), cells, height_at, [](UtcTime) { return 7.0; },
      [](UtcTime) { return 250.0; });
  return made;
}

TEST(WhatCame, IsTheTruthInOneFuture) {
  tests::KnownSeriesForTests known = sea(end_of_day + hours(48));
  const SiteData data = tests::site_of({known.data});
  const auto came = what_came(data, forecast(), "model", UtcTime::max());
  ASSERT_NE(came, nullptr);
  EXPECT_EQ(came->members, 1U);
  ASSERT_EQ(came->time.size(), stamps);
  const ForecastColumn& column = came->columns.front();
  EXPECT_TRUE(column.member_m_s.empty());
  EXPECT_TRUE(column.wind_member_m_s.empty());
  for (std::size_t t = 0; t < stamps; ++t) {
    const UtcTime time = came->time[t];
    EXPECT_LT(std::abs(column.wind_m_s[t] - wind_at(time)), 1e-9);
    EXPECT_NEAR(column.sea[t].significant_height_m, height_at(time), 1e-9);
    EXPECT_EQ(column.sea[t].peak_period_s, 7);
    EXPECT_EQ(column.sea[t].from_direction_deg, 250);
    EXPECT_EQ(column.height_spread[t], 0);
    for (std::size_t k = 0; k < depths.size(); ++k)
      EXPECT_LT(std::abs(column.current_m_s[2 * t + k] - current_at(time, depths[k])), 1e-9);
  }
}

// Of waves that nobody measures later than noon the truth is known until noon.
TEST(WhatCame, EndsWhereSomethingIsUnknown) {
  tests::KnownSeriesForTests known = sea(end_of_day + hours(36));
  const SiteData data = tests::site_of({known.data});
  EXPECT_EQ(what_came(data, forecast(), "model", UtcTime::max())->time.back(),
            end_of_day + hours(36));
  EXPECT_EQ(what_came(data, forecast(), "model", end_of_day + hours(20))->time.back(),
            end_of_day + hours(20));
  EXPECT_EQ(what_came(data, forecast(), "model", end_of_day - hours(3)), nullptr);
  EXPECT_EQ(what_came(data, forecast(), "another", UtcTime::max()), nullptr)
      << "currents of another dataset are no truth of these";
}

TEST(WhatCame, IsALineAcrossThreeHoursAndEndsAtAWiderHole) {
  tests::KnownSeriesForTests known;
  const auto cells = [&](Duration step) {
    return tests::instants(end_of_day - hours(24), end_of_day + hours(48), step);
  };
  known.current(tests::analysis_of("model"), cells(hours(1)), depths, current_at);
  known.wind(tests::analysis_of("wind"), cells(hours(3)),
             [](UtcTime t, double) { return wind_at(t); });
  known.waves(
      tests::analysis_of("waves"), cells(hours(1)),
      [](UtcTime time) {
        const double h = hours_between(end_of_day, time);
        return h > 10 && h < 15 ? std::nan("") : height_at(time);
      },
      [](UtcTime) { return 7.0; }, [](UtcTime) { return 250.0; });
  const SiteData data = tests::site_of({known.data});
  const auto came = what_came(data, forecast(), "model", UtcTime::max());
  ASSERT_NE(came, nullptr);
  EXPECT_EQ(came->time.back(), end_of_day + hours(10));
  for (std::size_t t = 0; t < came->time.size(); ++t)
    EXPECT_LT(std::abs(came->columns.front().wind_m_s[t] - wind_at(came->time[t])), 1e-9);
}

// A finer product that knows heights alone has no period; that of another is not lent to it.
TEST(WhatCame, HasPeriodsAndDirectionsOfTheRunWhoseHeightCame) {
  tests::KnownSeriesForTests known = sea(end_of_day + hours(48));
  Origin finer = tests::analysis_of("finer");
  finer.rank.is_regional = true;
  known.waves(
      finer, tests::instants(end_of_day - hours(24), end_of_day + hours(48)),
      [](UtcTime) { return 2.5; }, [](UtcTime) { return std::nan(""); },
      [](UtcTime) { return 310.0; });
  const SiteData data = tests::site_of({known.data});
  const auto came = what_came(data, forecast(), "model", UtcTime::max());
  ASSERT_NE(came, nullptr);
  for (const SeaState& sea : came->columns.front().sea) {
    EXPECT_EQ(sea.significant_height_m, 2.5);
    EXPECT_EQ(sea.peak_period_s, 15) << "as it was forecast";
    EXPECT_EQ(sea.from_direction_deg, 310);
  }
}

// A provider's run is no truth, whoever made the forecast.
TEST(WhatCame, IsNoForecast) {
  tests::KnownSeriesForTests known;
  const auto cells = tests::instants(end_of_day - hours(24), end_of_day + hours(48));
  known.current(tests::analysis_of("model"), cells, depths, current_at);
  known.wind(tests::forecast_of("wind", end_of_day), cells,
             [](UtcTime t, double) { return wind_at(t); });
  known.waves(
      tests::analysis_of("waves"), cells, height_at, [](UtcTime) { return 7.0; },
      [](UtcTime) { return 250.0; });
  const SiteData data = tests::site_of({known.data});
  EXPECT_EQ(what_came(data, forecast(), "model", UtcTime::max()), nullptr);
}

}  // namespace
}  // namespace slackwater::calibration::what_came_test
