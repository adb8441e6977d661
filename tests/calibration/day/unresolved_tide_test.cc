#include "calibration/day/column/unresolved_tide.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "calibration/day/daily_forecast.h"
#include "tests/support/known_series_for_tests.h"

namespace slackwater::calibration::unresolved_tide_test {
namespace {

using std::chrono::days;
using std::chrono::hours;
using namespace tests;

const UtcDay day = parse_day("2024-06-11");
const UtcTime end_of_day = UtcTime(day) + days(1);
const std::vector<double> depth_m{2, 20};

/// M2, 12.4206 h.
constexpr double m2_rad_h = 2 * std::numbers::pi / 12.4206012;
const Horizontal residual(0.06, -0.02);
constexpr double along_m_s = 0.8;
constexpr double across_m_s = 0.1;

Horizontal tide(UtcTime time, double depth) {
  const double phase = m2_rad_h * hours_between(UtcTime(day), time);
  const double share = 1 - depth / 100;
  return share * Horizontal(along_m_s * std::cos(phase), across_m_s * std::sin(phase));
}

/// What a mean over so many hours keeps of the tide.
double passed(Duration averaging) {
  const double half =
      0.5 * m2_rad_h * std::chrono::duration<double, std::ratio<3600>>(averaging).count();
  return half > 0 ? std::sin(half) / half : 1;
}

/// A dataset of its own for means over `averaging` (0: instants by the hour).
void add_currents(KnownSeriesForTests& sea, const std::string& name, UtcTime from, UtcTime to,
                  Duration averaging) {
  const auto time = averaging > Duration(0) ? means(from, to, averaging) : instants(from, to);
  sea.current(analysis_of(name), time, depth_m, [=](UtcTime at, double depth) {
    return residual + passed(averaging) * tide(at, depth);
  });
}

DailyForecast forecast(const KnownSeriesForTests& sea) {
  ForecastOptions options;
  options.issued = end_of_day + hours(5);
  options.horizon = hours(72);
  return make_forecast(site_of({sea.data}), options);
}

/// Share of the components at the stamps after D whose truth lies between p10 and p90.
double share_inside(const Snapshot& s) {
  double inside = 0;
  double all = 0;
  const ForecastColumn& column = s.columns.front();
  for (std::size_t t = 1; t < s.time.size(); ++t) {
    for (std::size_t k = 0; k < s.depth_m.size(); ++k) {
      const std::size_t o = t * s.depth_m.size() + k;
      const Horizontal miss = residual + tide(s.time[t], s.depth_m[k]) - column.current_m_s[o];
      const double band = 1.2815515655446004 * column.current_sigma_m_s[o];
      inside += (std::abs(miss.real()) <= band ? 1 : 0) + (std::abs(miss.imag()) <= band ? 1 : 0);
      all += 2;
    }
  }
  return inside / all;
}

TEST(UnresolvedTide, ADailyMeanIsWidenedByTheTideOfAnEarlierHourlyRecord) {
  KnownSeriesForTests sea;
  add_currents(sea, "daily", end_of_day - days(20), end_of_day, days(1));
  const Snapshot narrow = forecast(sea).snapshot;
  add_currents(sea, "hourly", end_of_day - days(40), end_of_day - days(6), Duration(0));
  const Snapshot wide = forecast(sea).snapshot;
  ASSERT_TRUE(wide.averaged);
  EXPECT_EQ(wide.averaged->averaging, days(1));
  EXPECT_FALSE(wide.averaged->holds_part_of_the_tide);
  EXPECT_EQ(wide.averaged->tidal_record, "hourly");
  // The standard deviation of a sine, along the longer axis of the ellipse: amplitude over root 2.
  ASSERT_TRUE(wide.averaged->unresolved_tide_m_s);
  EXPECT_NEAR(*wide.averaged->unresolved_tide_m_s, 0.98 * along_m_s / std::numbers::sqrt2,
              0.03 * along_m_s)
      << "25 hours are not two periods to the minute";
  EXPECT_GE(share_inside(wide), 0.8);
  for (std::size_t t = 0; t < wide.time.size(); ++t) {
    const std::size_t o = t * depth_m.size();
    const double more = std::pow(wide.columns[0].current_sigma_m_s[o], 2) -
                        std::pow(narrow.columns[0].current_sigma_m_s[o], 2);
    EXPECT_NEAR(std::sqrt(more), 0.98 * along_m_s / std::numbers::sqrt2, 0.03 * along_m_s) << t;
  }
  EXPECT_EQ(wide.columns[0].current_m_s, narrow.columns[0].current_m_s) << "the mean is the mean";
}

TEST(UnresolvedTide, ItsAbsenceIsStatedWhereNoRecordTellsOfIt) {
  KnownSeriesForTests sea;
  add_currents(sea, "daily", end_of_day - days(20), end_of_day, days(1));
  const Snapshot made = forecast(sea).snapshot;
  EXPECT_TRUE(made.degraded);
  EXPECT_NE(
      made.headline.find(
          "he currents are daily means: they do not hold the tide, and its size is not known"),
      std::string::npos)
      << made.headline;
  ASSERT_TRUE(made.averaged);
  EXPECT_FALSE(made.averaged->unresolved_tide_m_s) << "unknown is not zero";
}

TEST(UnresolvedTide, MeansOverSixAndTwelveHoursAreNoInstantsEither) {
  for (const Duration averaging : {Duration(hours(6)), Duration(hours(12))}) {
    KnownSeriesForTests sea;
    add_currents(sea, "means", end_of_day - days(20), end_of_day, averaging);
    add_currents(sea, "hourly", end_of_day - days(40), end_of_day - days(6), Duration(0));
    const Snapshot made = forecast(sea).snapshot;
    ASSERT_TRUE(made.averaged) << averaging.count();
    EXPECT_EQ(made.averaged->averaging, averaging);
    EXPECT_TRUE(made.degraded) << made.headline;
    EXPECT_GE(share_inside(made), 0.8) << made.headline;
  }
}

TEST(UnresolvedTide, WhatMeansOverSixHoursLetThroughIsNotCountedTwice) {
  // Two thirds of M2 pass through six hours: the record of means finds all of it again.
  KnownSeriesForTests sea;
  add_currents(sea, "means", end_of_day - days(30), end_of_day, hours(6));
  add_currents(sea, "hourly", end_of_day - days(45), end_of_day - days(6), Duration(0));
  const Snapshot made = forecast(sea).snapshot;
  ASSERT_TRUE(made.averaged);
  EXPECT_TRUE(made.averaged->holds_part_of_the_tide);
  ASSERT_TRUE(made.averaged->unresolved_tide_m_s);
  EXPECT_LT(*made.averaged->unresolved_tide_m_s, 0.05);
  EXPECT_NE(made.headline.find("only part of the tide"), std::string::npos) << made.headline;
}

TEST(UnresolvedTide, HourlyMeansAndInstantsAreLeftAsTheyAre) {
  for (const Duration averaging : {Duration(0), Duration(hours(1)), Duration(hours(3))}) {
    KnownSeriesForTests sea;
    add_currents(sea, "model", end_of_day - days(20), end_of_day, averaging);
    add_currents(sea, "coarse", end_of_day - days(40), end_of_day - days(6), days(1));
    const Snapshot made = forecast(sea).snapshot;
    EXPECT_FALSE(made.averaged);
    EXPECT_EQ(made.headline.find("mean"), std::string::npos) << made.headline;
  }
}

TEST(UnresolvedTide, OtherDailyMeansAreNoRecordOfTheTide) {
  KnownSeriesForTests sea;
  add_currents(sea, "daily", end_of_day - days(20), end_of_day, days(1));
  add_currents(sea, "other", end_of_day - days(30), end_of_day - days(1), days(1));
  ASSERT_TRUE(forecast(sea).snapshot.averaged);
  EXPECT_FALSE(forecast(sea).snapshot.averaged->unresolved_tide_m_s);
}

TEST(UnresolvedTide, MembersRunWithTheTideEachAtAPhaseOfItsOwn) {
  KnownSeriesForTests sea;
  add_currents(sea, "daily", end_of_day - days(20), end_of_day, days(1));
  add_currents(sea, "hourly", end_of_day - days(40), end_of_day - days(6), Duration(0));
  const Snapshot made = forecast(sea).snapshot;
  const ForecastColumn& column = made.columns.front();
  const std::size_t size = column.current_m_s.size();
  const std::size_t members = made.members - 1;
  ASSERT_EQ(column.member_m_s.size(), members * size);
  double square = 0;
  for (std::size_t o = 0; o < size; ++o) {
    Horizontal sum{};
    for (std::size_t m = 0; m < members; ++m) {
      const Horizontal departure = column.member_m_s[m * size + o] - column.current_m_s[o];
      sum += departure;
      square += departure.real() * departure.real();
    }
    EXPECT_LT(std::abs(sum) / double(members), column.current_sigma_m_s[o])
        << "members stand around the centre";
  }
  const double spread_m_s = std::sqrt(square / double(size * members));
  EXPECT_GT(spread_m_s, 0.35) << "an amplitude of 0.7 to 0.8 m/s is in the members";
  EXPECT_LT(spread_m_s, 0.8);
}

TEST(UnresolvedTide, IsLookedForUpToTheEndOfTheDayAlone) {
  KnownSeriesForTests sea;
  add_currents(sea, "daily", end_of_day - days(20), end_of_day, days(1));
  add_currents(sea, "hourly", end_of_day + hours(1), end_of_day + days(20), Duration(0));
  EXPECT_FALSE(forecast(sea).snapshot.averaged->unresolved_tide_m_s);
}

}  // namespace
}  // namespace slackwater::calibration::unresolved_tide_test
