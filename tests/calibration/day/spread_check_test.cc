// A weather ensemble's spread against its error: made-up runs of which the truth is one more
// member, or which spread half as much.
#include "calibration/day/given/spread_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "calibration/day/daily_forecast.h"
#include "calibration/day/given/driving_ensemble.h"
#include "calibration/day/given/horizon.h"
#include "fields/base/numbers/random.h"
#include "tests/support/known_series_for_tests.h"

namespace slackwater::calibration::spread_check_test {
namespace {

using std::chrono::days;
using std::chrono::hours;
using namespace tests;

const UtcTime end_of_day = parse_utc("2024-06-12T00:00:00Z");
constexpr int members = 8;

Horizontal true_wind(UtcTime time, double) {
  const double hour = hours_between(end_of_day, time);
  return {6 + 3 * std::sin(0.09 * hour), 4 * std::cos(0.05 * hour)};
}

/// One draw of how wrong a run's wind may be: it grows in two days and turns within a day.
FlowForTests error_of(std::uint64_t seed, UtcTime issued, int member) {
  Rng random(seed, format_utc(issued) + "/" + std::to_string(member));
  const auto drawn = [&] { return Horizontal(random.normal(), random.normal()); };
  const Horizontal first = drawn();
  const Horizontal second = drawn();
  return [=](UtcTime time, double) {
    const double lead_h = hours_between(issued, time);
    return 1.2 * std::min(1.0, 0.4 + lead_h / 48) *
           (first * std::polar(1.0, 0.21 * lead_h) + second * std::polar(1.0, -0.13 * lead_h));
  };
}

Origin member_of(UtcTime issued, int number, const std::string& dataset) {
  Origin origin = forecast_of(dataset, issued, 100 + number);
  origin.ensemble_member = number;
  return origin;
}

struct PastForTests {
  int days = 30;
  double spread = 1;  ///< 1: the truth is one more member
  std::uint64_t seed = 1;
  int member_step_h = 6;
  Duration truth_step = hours(3);
  std::string dataset = "ens";
};

/// A run issued at the end of a day: its centre is off the truth by one draw, members off the
/// centre by others, times `spread`.
void add_run(KnownSeriesForTests& sea, UtcTime issued, const PastForTests& past) {
  const FlowForTests off = error_of(past.seed, issued, 0);
  for (int n = 1; n <= members; ++n) {
    const FlowForTests own = error_of(past.seed, issued, n);
    sea.wind(member_of(issued, n, past.dataset),
             instants(issued, issued + hours(72), hours(past.member_step_h)),
             [=, spread = past.spread](UtcTime time, double) {
               return true_wind(time, 0) - off(time, 0) + spread * own(time, 0);
             });
  }
}

KnownSeriesForTests sea_with(const PastForTests& past) {
  KnownSeriesForTests sea;
  sea.wind(analysis_of("wind", 2), instants(end_of_day - days(40), end_of_day, past.truth_step),
           true_wind);
  for (int day = past.days; day >= 0; --day) add_run(sea, end_of_day - days(day), past);
  return sea;
}

SpreadCheck checked(const KnownSeriesForTests& sea, const std::string& dataset = "ens",
                    UtcTime until = end_of_day) {
  const Knowledge known{until, until, UtcTime::min(), UtcTime::max()};
  return check_spread(sea.data.wind, dataset, known, choose(sea.data.wind, known, {}).column,
                      until);
}

TEST(SpreadCheck, HalfTheRightSpreadIsDoubledAfterEnoughDays) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const SpreadCheck check = checked(sea_with({.days = 30, .spread = 0.5, .seed = seed}));
    ASSERT_EQ(check.lead.size(), 3u);
    for (const CheckedLead& lead : check.lead) {
      EXPECT_GE(lead.days, 28u);
      // Thirty days of two components each know a root mean square to a tenth.
      EXPECT_NEAR(lead.factor, 2.0, 0.5) << "seed " << seed;
      EXPECT_DOUBLE_EQ(lead.factor, lead.rms_error_m_s / lead.rms_spread_m_s);
    }
  }
}

TEST(SpreadCheck, IsUnbiasedAndCountsTheTruthAsOneMoreMember) {
  // Members 2, 1, 0, 1, 2 m/s either side of calm, one truth of 3 m/s: by hand, per component.
  KnownSeriesForTests sea;
  const UtcTime issued = end_of_day - days(1);
  sea.wind(analysis_of("wind", 2), {TimeCell::instant(issued + hours(6))}, steady({3, 0}));
  for (int n = 1; n <= 5; ++n) {
    sea.wind(member_of(issued, n, "ens"), instants(issued, end_of_day, hours(6)),
             steady({n - 3.0, 0}));
  }
  const SpreadCheck check = checked(sea);
  ASSERT_EQ(check.lead.size(), 1u);
  EXPECT_EQ(check.lead[0].days, 1u);
  EXPECT_DOUBLE_EQ(check.lead[0].rms_error_m_s, std::sqrt(9.0 / 2));
  EXPECT_DOUBLE_EQ(check.lead[0].rms_spread_m_s, std::sqrt(6.0 / 5 * 10 / (2 * 4)));
}

TEST(SpreadCheck, OfManyEnsemblesTheRatioIsWhatWasMade) {
  // Unbiased, with (m + 1)/m: of exchangeable truth and members the mean squares are equal, of
  // members at half the distance error and spread are (1 + 0.25/m) and 0.25 (m + 1)/m.
  for (const double spread : {1.0, 0.5}) {
    double error = 0;
    double of_members = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const SpreadCheck check =
          checked(sea_with({.days = 36, .spread = spread, .seed = 100 + seed}));
      error += std::pow(check.lead[0].rms_error_m_s, 2);
      of_members += std::pow(check.lead[0].rms_spread_m_s, 2);
    }
    const double expected =
        (1 + spread * spread / members) / (spread * spread * (1 + 1.0 / members));
    EXPECT_NEAR(error / of_members / expected, 1, 0.18) << "144 days of four numbers each: 3 s.e.";
  }
}

TEST(SpreadCheck, TheRightSpreadIsLeftAsItIs) {
  int scaled = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    for (const CheckedLead& lead : checked(sea_with({.days = 30, .seed = seed})).lead) {
      EXPECT_NEAR(lead.rms_error_m_s / lead.rms_spread_m_s, 1, 0.35);
      scaled += lead.factor != 1 ? 1 : 0;
    }
  }
  EXPECT_LE(scaled, 3) << "of eighteen intervals of 95 %, one misses 1";
}

TEST(SpreadCheck, TooFewDaysLeaveTheSpreadAsItIs) {
  const SpreadCheck check = checked(sea_with({.days = 9, .spread = 0.5}));
  EXPECT_FALSE(check.is_checked());
  for (const double lead_h : {0.0, 12.0, 70.0}) EXPECT_EQ(check.factor_at(lead_h), 1);
  EXPECT_EQ(
      text_of(check),
      "its spread is not checked yet: 9 days with an analysed wind are stored, 10 are needed");
  EXPECT_EQ(checked(sea_with({.days = 10, .spread = 0.5})).lead[0].days, 10u);
  EXPECT_NE(text_of(SpreadCheck{}).find("0 days with an analysed wind are stored"),
            std::string::npos);
}

TEST(SpreadCheck, RunsTwiceADayAreNoMoreDays) {
  KnownSeriesForTests sea = sea_with({.days = 6, .spread = 0.5});
  for (int day = 6; day >= 1; --day)
    add_run(sea, end_of_day - days(day) + hours(12), {.spread = 0.5, .seed = 2});
  EXPECT_EQ(checked(sea).lead[0].days, 6u);
}

TEST(SpreadCheck, NothingIsLearntFromWhatCameLaterOrFromAnotherProduct) {
  const KnownSeriesForTests sea = sea_with({.days = 30, .spread = 0.5});
  KnownSeriesForTests spoilt = sea_with({.days = 30, .spread = 0.5});
  const UtcTime then = end_of_day - days(5);
  spoil_after(spoilt.data, then, then);
  const SpreadCheck one = checked(sea, "ens", then);
  const SpreadCheck other = checked(spoilt, "ens", then);
  ASSERT_EQ(one.lead.size(), other.lead.size());
  for (std::size_t day = 0; day < one.lead.size(); ++day) {
    EXPECT_EQ(one.lead[day].rms_error_m_s, other.lead[day].rms_error_m_s);
    EXPECT_EQ(one.lead[day].factor, other.lead[day].factor);
  }
  EXPECT_TRUE(checked(sea, "another").lead.empty());
}

TEST(SpreadCheck, ForecastsAreNoTruthAndCoarseAnalysesServeAtTheirOwnHours) {
  KnownSeriesForTests sea;
  sea.wind(forecast_of("control", end_of_day - days(40)),
           instants(end_of_day - days(40), end_of_day), true_wind);
  for (int day = 30; day >= 0; --day) add_run(sea, end_of_day - days(day), {});
  EXPECT_TRUE(checked(sea).lead.empty()) << "nothing was analysed";
  const SpreadCheck coarse = checked(sea_with({.days = 20, .truth_step = hours(6)}));
  EXPECT_EQ(coarse.lead.at(0).days, 20u);
}

TEST(SpreadCheck, TheFactorPassesFromDayToDayAndIsHeldOutside) {
  SpreadCheck check;
  check.lead = {{20, 2, 1, 2.0}, {3, 1, 1, 1.0}, {20, 1, 1, 1.0}, {4, 1, 1, 1.0}};
  EXPECT_DOUBLE_EQ(check.factor_at(0), 2.0);
  EXPECT_DOUBLE_EQ(check.factor_at(12), 2.0);
  EXPECT_DOUBLE_EQ(check.factor_at(36), 1.5) << "a day that is not checked lies between";
  EXPECT_DOUBLE_EQ(check.factor_at(60), 1.0);
  EXPECT_DOUBLE_EQ(check.factor_at(200), 1.0);
}

TEST(SpreadCheck, AFactorIsBounded) {
  EXPECT_EQ(checked(sea_with({.days = 20, .spread = 0.05})).lead[0].factor, most_spread_factor);
  EXPECT_EQ(checked(sea_with({.days = 20, .spread = 20})).lead[0].factor, least_spread_factor);
}

/// Root mean square departure of a component of the members from their mean, over the stamps.
double spread_of(const WindDepartures& departures, std::size_t stamps) {
  double squares = 0;
  double count = 0;
  for (std::size_t t = 1; t < stamps; ++t) {
    Horizontal mean{};
    for (std::size_t n = 0; n < members; ++n)
      mean += departures.departure_m_s[n * stamps + t] / double(members);
    for (std::size_t n = 0; n < members; ++n) {
      squares += 0.5 * std::norm(departures.departure_m_s[n * stamps + t] - mean);
      count += 1;
    }
  }
  return std::sqrt(squares / count);
}

TEST(SpreadCheck, WhatDrivesTheForecastIsScaledAboutTheMeanOfTheMembers) {
  std::vector<UtcTime> stamps;
  for (int h = 0; h <= 72; ++h) stamps.push_back(end_of_day + hours(h));
  const KnownSeriesForTests sea = sea_with({.days = 30, .spread = 0.5, .member_step_h = 1});
  HorizonWind wind = horizon_wind(sea.data.wind, WindPolicy::best, end_of_day, stamps,
                                  {.known_by = end_of_day + hours(5)});
  ASSERT_TRUE(wind.member_run.spread.is_checked());
  const WindDepartures scaled = departures_of(wind, stamps);
  HorizonWind unchecked = wind;
  unchecked.member_run.spread = {};
  const WindDepartures as_stored = departures_of(unchecked, stamps);
  EXPECT_NEAR(spread_of(scaled, 73) / spread_of(as_stored, 73), 2.0, 0.5);
  for (std::size_t t = 1; t < 73; ++t) {
    Horizontal apart{};
    for (std::size_t n = 0; n < members; ++n)
      apart += scaled.departure_m_s[n * 73 + t] - as_stored.departure_m_s[n * 73 + t];
    EXPECT_NEAR(std::abs(apart), 0, 1e-11) << "the mean stays where it was";
  }
}

TEST(SpreadCheck, TheForecastNamesItAndIsAsItWasWithTooFewDays) {
  const auto made_with = [](const PastForTests& past) {
    KnownSeriesForTests sea = sea_with(past);
    sea.current(analysis_of("model", 1), instants(end_of_day - days(5), end_of_day), {2.0, 8.0},
                [](UtcTime time, double depth) {
                  return 0.02 * std::exp(-depth / 12) * true_wind(time, 0);
                });
    ForecastOptions options;
    options.day = day_of(end_of_day - days(1));
    options.issued = end_of_day + hours(5);
    options.horizon = hours(48);
    DailyForecast made = make_forecast(site_of({sea.data}), options);
    std::string notes;
    for (const std::string& note : made.columns.front().notes) notes += note + "\n";
    return std::pair(made.snapshot.columns.front(), notes);
  };
  const auto [few, few_notes] = made_with({.days = 6, .spread = 0.5});
  EXPECT_NE(few_notes.find("not checked yet"), std::string::npos) << few_notes;
  const auto [none, none_notes] = made_with({.days = 0, .spread = 0.5});
  EXPECT_EQ(few.wind_member_m_s, none.wind_member_m_s);
  const auto [many, many_notes] = made_with({.days = 30, .spread = 0.5});
  EXPECT_NE(many_notes.find("its spread was checked against its error: day 1 times "),
            std::string::npos)
      << many_notes;
  EXPECT_NE(many.wind_member_m_s, none.wind_member_m_s);
}

}  // namespace
}  // namespace slackwater::calibration::spread_check_test
