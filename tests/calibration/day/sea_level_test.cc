#include "calibration/day/given/sea_level.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numeric>

#include "calibration/day/daily_forecast.h"
#include "calibration/tide/level_tide.h"
#include "calibration/tide/surge.h"
#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/numbers/random.h"
#include "fields/current/astronomy.h"
#include "tests/support/known_series_for_tests.h"

// The level of the sea beyond D: harmonic tide, surge, the provider's own.

namespace slackwater::calibration::sea_level_test {
namespace {

using std::chrono::days;
using std::chrono::hours;
using namespace tests;

const UtcDay day = parse_day("2024-06-11");
const UtcTime end_of_day = UtcTime(day) + days(1);

struct Line {
  const char* name;
  double amplitude_m;
  double lag_rad;
};
/// As in the bay of Saint-Brieuc (api/made_up/synthetic/tide.cc), with the K2 and P1 that a real
/// sea has beside S2 and K1: a little off the equilibrium ratio that a month of record infers them
/// by.
const std::vector<Line> saint_brieuc{{"M2", 3.60, 2.97}, {"S2", 1.33, 3.80}, {"N2", 0.71, 2.65},
                                     {"K1", 0.09, 1.71}, {"O1", 0.07, 6.20}, {"M4", 0.17, 4.89},
                                     {"K2", 0.38, 3.78}, {"P1", 0.031, 1.68}};

double tide_m(UtcTime time) {
  double sum_m = 0;
  for (const Line& line : saint_brieuc)
    sum_m += line.amplitude_m *
             std::cos(astronomical_argument_rad(tidal_constituent(line.name), time) - line.lag_rad);
  return sum_m;
}

/// Weather on top of the tide: 0.15 m, forgotten within 36 h.
class Surge {
 public:
  explicit Surge(std::uint64_t seed, UtcTime first) : first_(first) {
    Rng rng(seed, "tests/surge");
    const double kept = std::exp(-1 / 36.0);
    double now_m = 0.15 * rng.normal();
    for (int h = 0; h < 24 * 100; ++h) {
      hour_m_.push_back(now_m);
      now_m = kept * now_m + 0.15 * std::sqrt(1 - kept * kept) * rng.normal();
    }
  }
  [[nodiscard]] double at(UtcTime time) const {
    return hour_m_[static_cast<std::size_t>(std::lround(hours_between(first_, time)))];
  }

 private:
  UtcTime first_;
  std::vector<double> hour_m_;
};

ForecastPlan plan_for(int horizon_h = 72) {
  ForecastPlan plan;
  plan.day = day;
  plan.issued = end_of_day + hours(5);
  for (int h = 0; h <= horizon_h; ++h) plan.stamps.push_back(end_of_day + hours(h));
  return plan;
}

KnownSeriesForTests sea_of(int record_days, const LevelForTests& level_m) {
  KnownSeriesForTests made;
  made.sea_level(analysis_of("level"), instants(end_of_day - days(record_days), end_of_day),
                 level_m);
  return made;
}

bool tells(const LevelForecast& made, const std::string& of) {
  for (const std::string& note : made.notes)
    if (note.find(of) != std::string::npos) return true;
  return false;
}

double rms(const std::vector<double>& errors) {
  return std::sqrt(std::inner_product(errors.begin(), errors.end(), errors.begin(), 0.0) /
                   static_cast<double>(errors.size()));
}

TEST(SeaLevel, AMadeTideIsForecastToFiveMicrometres) {
  const auto sea = sea_of(200, [](UtcTime time) { return 0.25 + tide_m(time); });
  const LevelForecast made = forecast_level(sea.data.sea_level, plan_for());
  ASSERT_EQ(made.level.level_m.size(), 73U);
  for (std::size_t h = 0; h <= 72; ++h) {
    EXPECT_NEAR(made.level.level_m[h], 0.25 + tide_m(end_of_day + hours(h)), 5e-6) << h;
    EXPECT_EQ(made.level.source[h], DataStatus::modelled);
    EXPECT_GE(made.level.sigma_m[h], 0.03) << "what a cell says of a place, never 0";
  }
}

TEST(SeaLevel, WhatPastDaysWouldHaveHadExactlyIsNoSurerThanACellIsOfAPlace) {
  // M4 infers no other line, and none infers it.
  const auto sea = sea_of(30, [](UtcTime time) {
    return std::cos(astronomical_argument_rad(tidal_constituent("M4"), time));
  });
  const LevelForecast made = forecast_level(sea.data.sea_level, plan_for());
  ASSERT_FALSE(made.level.empty());
  for (const double sigma_m : made.level.sigma_m) EXPECT_DOUBLE_EQ(sigma_m, 0.03);
}

TEST(SeaLevel, ATideNearInertialMotionKeepsBothSenses) {
  // At 54 N a fortnight cannot tell M2 from inertial motion of 14.8 h; a level has none.
  const auto time = instants(end_of_day - days(14), end_of_day);
  std::vector<double> value_m;
  for (const TimeCell& cell : time) value_m.push_back(tide_m(cell.centre()));
  const std::vector<SampleStatus> status(time.size(), SampleStatus::ok);
  const TideFit fit = fit_level_tide(time, value_m, status);
  ASSERT_FALSE(fit.terms.empty());
  for (const TideTerm& term : fit.terms) {
    EXPECT_FALSE(term.near_inertial) << term.name;
    EXPECT_NEAR(std::abs(term.clockwise - std::conj(term.counter_clockwise)), 0, 1e-9);
  }
}

TEST(SeaLevel, BeatsTheMeanAndTheSameHourOfTheDayBefore) {
  std::vector<double> ours, same_hour, mean, scaled, later;
  constexpr int record_days = 30;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    const UtcTime first = end_of_day - days(record_days);
    const Surge surge(seed, first);
    const auto truth_m = [&](UtcTime time) { return tide_m(time) + surge.at(time); };
    const auto sea = sea_of(record_days, truth_m);
    const LevelForecast made = forecast_level(sea.data.sea_level, plan_for());
    ASSERT_EQ(made.level.level_m.size(), 73U);
    double mean_m = 0;
    for (int h = 0; h < 24 * record_days; ++h)
      mean_m += truth_m(first + hours(h)) / (24.0 * record_days);
    for (std::size_t h = 1; h <= 72; ++h) {
      const UtcTime time = end_of_day + hours(h);
      const double error_m = made.level.level_m[h] - truth_m(time);
      scaled.push_back(error_m / made.level.sigma_m[h]);
      if (h > 24) {
        later.push_back(error_m);
        continue;
      }
      ours.push_back(error_m);
      same_hour.push_back(truth_m(time - hours(24)) - truth_m(time));
      mean.push_back(mean_m - truth_m(time));
    }
  }
  std::printf(
      "level, day ahead: ours %.3f m, same hour of the day before %.3f m, mean %.3f m; "
      "days 2 and 3: %.3f m; error in standard deviations: %.2f\n",
      rms(ours), rms(same_hour), rms(mean), rms(later), rms(scaled));
  // Of a surge that is known at the end of D a day's forecast cannot know
  // 0.15 m sqrt(1 - (18/24)(1 - e^{-24/18})) = 0.10 m; the rest are lines that a month infers.
  EXPECT_LT(rms(ours), 0.20);
  EXPECT_LT(rms(ours), 0.25 * rms(same_hour));
  EXPECT_LT(rms(ours), 0.1 * rms(mean));
  // What the band says comes true: not twice as wide, nor half.
  EXPECT_GT(rms(scaled), 0.5);
  EXPECT_LT(rms(scaled), 1.5);
}

TEST(SeaLevel, CarriesASurgeOnThatPastDaysHaveShownToLast) {
  // Surges that last for a week are worth carrying on; those of one hour are not.
  const auto slow_m = [](UtcTime time) {
    return 0.4 * std::sin(constants::pi * hours_between(end_of_day, time) / (24 * 10) + 1.0);
  };
  Rng rng(5, "tests/white");
  std::vector<double> white_m;
  for (int h = 0; h < 24 * 40; ++h) white_m.push_back(0.2 * rng.normal());
  const UtcTime first = end_of_day - days(30);
  const auto white_at = [&](UtcTime time) {
    return white_m[static_cast<std::size_t>(std::lround(hours_between(first, time)))];
  };
  const auto column_of = [&](const LevelForTests& surge_m) {
    return sea_of(30, [&](UtcTime time) { return tide_m(time) + surge_m(time); })
        .data.sea_level.pieces.front()
        .column;
  };
  const LevelHindcast slow = hindcast_level(column_of(slow_m), hours(24));
  EXPECT_GE(slow.surge.memory, hours(24));
  EXPECT_EQ(slow.days, 15U) << "as far back as half of the record";
  const LevelHindcast white = hindcast_level(column_of(white_at), hours(24));
  EXPECT_GT(white.errors.sigma_m.front(), 0.17);
  EXPECT_LT(white.errors.sigma_m.front(), 0.30);
  EXPECT_LT(std::abs(departure_at_end(column_of(white_at), TideFit{}, Duration(0))), 20)
      << "a single value";
}

TEST(SeaLevel, ShareOfADepartureFallsByEInItsMemory) {
  const SurgeMemory surge{hours(12), hours(25)};
  EXPECT_DOUBLE_EQ(share_left(surge, Duration(0)), 1);
  EXPECT_DOUBLE_EQ(share_left(surge, hours(12)), std::exp(-1.0));
  EXPECT_EQ(share_left({Duration(0), Duration(0)}, hours(1)), 0);
  const LevelErrors errors{{0.1, 0.2}};
  EXPECT_EQ(errors.at(hours(11)), 0.1);
  EXPECT_EQ(errors.at(hours(12)), 0.2);
  EXPECT_EQ(errors.at(days(9)), 0.2) << "the last of them for all that is later";
}

TEST(SeaLevel, TheProvidersOwnForecastIsTakenAsItIsAndLeftWithoutAJump) {
  auto sea = sea_of(30, tide_m);
  // It has 0.3 m more than the record knows of.
  const auto surged_m = [](UtcTime time) { return tide_m(time) + 0.3; };
  sea.sea_level(forecast_of("level", end_of_day - hours(6)),
                instants(end_of_day - hours(6), end_of_day + hours(30)), surged_m);
  const LevelForecast made = forecast_level(sea.data.sea_level, plan_for());
  ASSERT_EQ(made.level.level_m.size(), 73U);
  for (std::size_t h = 0; h <= 72; ++h) {
    const double surge_m = made.level.level_m[h] - tide_m(end_of_day + hours(h));
    EXPECT_EQ(made.level.source[h], h <= 30 ? DataStatus::forecast : DataStatus::modelled) << h;
    if (h <= 30) {
      EXPECT_NEAR(surge_m, 0.3, 1e-12) << h;
      EXPECT_DOUBLE_EQ(made.level.sigma_m[h], 0.10) << "nobody has judged it: the prior";
    }
  }
  EXPECT_GE(made.level.sigma_m[40], 0.10) << "no surer beyond the provider than with it";
}

TEST(SeaLevel, OfAProviderWhoseRunsAreJudgedTheSpreadIsTheirOwnError) {
  auto sea = sea_of(30, tide_m);
  for (int back = 8; back >= 1; --back) {
    const UtcTime issued = end_of_day - days(back);
    sea.sea_level(forecast_of("level", issued, 10 + back), instants(issued, issued + days(1)),
                  [&](UtcTime time) { return tide_m(time) + (back % 2 == 0 ? 0.2 : -0.2); });
  }
  sea.sea_level(forecast_of("level", end_of_day, 30), instants(end_of_day, end_of_day + hours(72)),
                tide_m);
  const LevelForecast made = forecast_level(sea.data.sea_level, plan_for());
  ASSERT_FALSE(made.level.empty());
  EXPECT_EQ(made.level.source[5], DataStatus::forecast);
  EXPECT_NEAR(made.level.sigma_m[5], 0.2, 0.01);
}

TEST(SeaLevel, MeansOfADayAndLevelsWithoutTideHoldNoLevelOfAnyHour) {
  KnownSeriesForTests daily;
  daily.sea_level(analysis_of("daily"), means(end_of_day - days(30), end_of_day, hours(24)),
                  [](UtcTime) { return 0.1; });
  const LevelForecast of_means = forecast_level(daily.data.sea_level, plan_for());
  EXPECT_TRUE(of_means.level.empty());
  EXPECT_TRUE(of_means.origins.empty());
  EXPECT_TRUE(tells(of_means, "daily means, without the tide")) << of_means.notes.at(0);
  Origin detided = analysis_of("detided");
  detided.rank.has_tide = false;
  KnownSeriesForTests lacking;
  lacking.sea_level(detided, instants(end_of_day - days(30), end_of_day),
                    [](UtcTime) { return 0.1; });
  const LevelForecast without = forecast_level(lacking.data.sea_level, plan_for());
  EXPECT_TRUE(without.level.empty());
  EXPECT_TRUE(tells(without, "lack the tide"));
  // Beside hours they are passed over.
  daily.sea_level(analysis_of("hours"), instants(end_of_day - days(30), end_of_day), tide_m);
  EXPECT_NEAR(forecast_level(daily.data.sea_level, plan_for()).level.level_m.at(6),
              tide_m(end_of_day + hours(6)), 0.05);
}

TEST(SeaLevel, TwoDaysShowNoTideAndGiveNone) {
  const auto sea = sea_of(2, tide_m);
  const LevelForecast made = forecast_level(sea.data.sea_level, plan_for());
  EXPECT_TRUE(made.level.empty());
  EXPECT_TRUE(tells(made, "its record of 2.0 days")) << made.notes.at(0);
  EXPECT_TRUE(forecast_level({}, plan_for()).level.empty());
  EXPECT_TRUE(forecast_level({}, plan_for()).notes.empty()) << "who has none is told nothing";
}

TEST(SeaLevel, AnythingThatNobodyCouldKnowChangesNothing) {
  auto sea = sea_of(30, tide_m);
  sea.sea_level(analysis_of("level"), instants(end_of_day, end_of_day + days(3)), tide_m);
  sea.sea_level(forecast_of("level", end_of_day + hours(12)),
                instants(end_of_day + hours(12), end_of_day + hours(72)), tide_m);
  const LevelForecast before = forecast_level(sea.data.sea_level, plan_for());
  spoil_after(sea.data, end_of_day, end_of_day + hours(5));
  const LevelForecast after = forecast_level(sea.data.sea_level, plan_for());
  ASSERT_FALSE(before.level.empty());
  EXPECT_EQ(before.level.level_m, after.level.level_m);
  EXPECT_EQ(before.level.sigma_m, after.level.sigma_m);
}

TEST(SeaLevel, MovesNothingElseOfAForecast) {
  const auto made_of = [](bool with_level) {
    KnownSeriesForTests made;
    const auto time = instants(end_of_day - days(6), end_of_day);
    made.current(analysis_of("model"), time, {2, 10, 20}, [](UtcTime t, double depth_m) {
      return Horizontal(0.1 * tide_m(t), 0.02 * tide_m(t - hours(2))) * std::exp(-depth_m / 60);
    });
    made.wind(analysis_of("wind"), time, steady({6, 2}));
    if (with_level) made.sea_level(analysis_of("level"), time, tide_m);
    std::vector<ColumnData> columns;
    columns.push_back(made.data);
    ForecastOptions options;
    options.issued = end_of_day + hours(5);
    return make_forecast(site_of(std::move(columns)), options).snapshot;
  };
  const Snapshot with = made_of(true), without = made_of(false);
  EXPECT_TRUE(without.columns[0].sea_level.empty());
  EXPECT_EQ(with.columns[0].sea_level.level_m.size(), with.time.size());
  EXPECT_EQ(with.columns[0].current_m_s, without.columns[0].current_m_s);
  EXPECT_EQ(with.columns[0].current_sigma_m_s, without.columns[0].current_sigma_m_s);
  EXPECT_EQ(with.columns[0].member_m_s, without.columns[0].member_m_s);
  EXPECT_EQ(with.columns[0].wind_m_s, without.columns[0].wind_m_s);
  EXPECT_EQ(with.headline, without.headline);
  EXPECT_EQ(with.degraded, without.degraded);
}

TEST(SeaLevel, ALevelThatFailsIsNamedAndCostsNothingElse) {
  KnownSeriesForTests sea;
  const auto time = instants(end_of_day - days(5), end_of_day);
  sea.current(analysis_of("model"), time, {2, 10},
              [](UtcTime t, double) { return Horizontal(0.1 * tide_m(t), 0.1); });
  sea.sea_level(analysis_of("level"), time, tide_m);
  const auto made_with = [&](const DayParts& parts) {
    ForecastOptions options;
    options.issued = end_of_day + hours(5);
    options.parts = parts;
    return make_forecast(site_of({sea.data}), options);
  };
  DayParts broken;
  broken.of_column.sea_level = [](const ScalarRecord&, const ForecastPlan&) -> LevelForecast {
    throw Error(ErrorKind::invalid_input, "the gauge stands on land");
  };
  const DailyForecast with = made_with({}), without = made_with(broken);
  EXPECT_TRUE(without.snapshot.degraded);
  EXPECT_NE(without.snapshot.headline.find("the level of the sea failed, none is forecast: the "
                                           "gauge stands on land"),
            std::string::npos)
      << without.snapshot.headline;
  EXPECT_TRUE(without.snapshot.columns[0].sea_level.empty());
  EXPECT_FALSE(with.snapshot.columns[0].sea_level.empty());
  EXPECT_EQ(with.snapshot.columns[0].current_m_s, without.snapshot.columns[0].current_m_s);
}

}  // namespace
}  // namespace slackwater::calibration::sea_level_test
