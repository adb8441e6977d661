#include "calibration/day/horizon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fields/base/error.h"
#include "fields/wave/growth.h"
#include "tests/support/known_series_for_tests.h"

namespace slackwater::calibration {
namespace {

using std::chrono::days;
using std::chrono::hours;
using namespace tests;

const UtcDay day = parse_day("2024-06-11");
const UtcTime end_of_day = UtcTime(day) + days(1);
constexpr WindPolicy all_policies[] = {WindPolicy::best, WindPolicy::forecast, WindPolicy::persist};

std::vector<UtcTime> stamps_to(int last_h, int first_h = 0) {
  std::vector<UtcTime> stamps;
  for (int h = first_h; h <= last_h; ++h) stamps.push_back(end_of_day + hours(h));
  return stamps;
}

/// Linear in time, so that interpolation in between is exact.
Horizontal rising(UtcTime time, double) {
  const double hour = hours_between(end_of_day, time);
  return {8 + 0.1 * hour, -3 + 0.05 * hour};
}

FlowForTests rising_plus(double more) {
  return [more](UtcTime time, double depth) { return rising(time, depth) + more; };
}

std::size_t count(const std::vector<DataStatus>& source, DataStatus status) {
  return static_cast<std::size_t>(std::count(source.begin(), source.end(), status));
}

TEST(WindPolicyNames, AreReadAsTheyAreWritten) {
  for (const WindPolicy policy : all_policies) EXPECT_EQ(wind_policy_from(name_of(policy)), policy);
  try {
    (void)wind_policy_from("storm");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
    EXPECT_NE(error.message().find("'storm'"), std::string::npos);
  }
}

TEST(HorizonWind, IsEmptyWhereNoWindIsStored) {
  for (const WindPolicy policy : all_policies) {
    const HorizonWind wind = horizon_wind({}, policy, end_of_day, stamps_to(24));
    EXPECT_FALSE(wind.series);
    EXPECT_TRUE(wind.wind_m_s.empty());
    EXPECT_TRUE(wind.source.empty());
    EXPECT_TRUE(wind.origins.empty());
  }
  KnownSeriesForTests later;
  later.wind(analysis_of("wind"), instants(end_of_day + hours(1), end_of_day + days(1)), rising);
  EXPECT_TRUE(horizon_wind(later.data.wind, WindPolicy::forecast, end_of_day, stamps_to(24))
                  .wind_m_s.empty())
      << "nothing was known by the end of D";
}

TEST(HorizonWind, PersistedWindStartsAtTheLastValueAndForgetsItForTheMean) {
  KnownSeriesForTests sea;
  sea.wind(analysis_of("wind"), instants(end_of_day - days(4), end_of_day), rising);
  const std::vector<UtcTime> stamps = stamps_to(24 * 30);
  const HorizonWind wind = horizon_wind(sea.data.wind, WindPolicy::persist, end_of_day, stamps);
  ASSERT_EQ(wind.wind_m_s.size(), stamps.size());
  const Horizontal last = rising(end_of_day, 0);
  const Horizontal mean = rising(end_of_day - days(2), 0);  // of a straight line: its middle
  EXPECT_EQ(wind.wind_m_s[0], last);
  for (std::size_t h = 0; h < stamps.size(); ++h) {
    const Horizontal expected = mean + std::exp(-double(h) / 24) * (last - mean);
    EXPECT_NEAR(std::abs(wind.wind_m_s[h] - expected), 0, 1e-12) << "rounding, " << h << " h";
  }
  EXPECT_NEAR(std::abs(wind.wind_m_s.back() - mean), 0, 1e-9);
  EXPECT_EQ(wind.source[0], DataStatus::analysis);
  EXPECT_EQ(count(wind.source, DataStatus::persisted), stamps.size() - 1);
}

TEST(HorizonWind, PersistedWindSeesNothingAfterTheDay) {
  KnownSeriesForTests sea;
  sea.wind(analysis_of("wind"), instants(end_of_day - days(4), end_of_day + days(3)), rising);
  sea.wind(forecast_of("wind", end_of_day - hours(12)),
           instants(end_of_day - hours(12), end_of_day + days(3)), rising_plus(1));
  ColumnData spoilt = sea.data;
  spoil_all_after(spoilt, end_of_day);
  const auto made = [&](const ColumnData& data) {
    return horizon_wind(data.wind, WindPolicy::persist, end_of_day, stamps_to(72));
  };
  EXPECT_EQ(made(sea.data).wind_m_s, made(spoilt).wind_m_s);
  EXPECT_EQ(made(sea.data).series->value, made(spoilt).series->value);
  EXPECT_EQ(made(sea.data).origins, made(spoilt).origins);
}

/// Analysed to a day after D; forecasts that were issued before and after the end of D.
KnownSeriesForTests analysed_and_forecast() {
  KnownSeriesForTests sea;
  sea.wind(analysis_of("wind"), instants(end_of_day - days(4), end_of_day + days(1)), rising);
  const auto run = [&](int issued_h, double more) {
    const UtcTime issued = end_of_day + hours(issued_h);
    sea.wind(forecast_of("wind", issued), instants(issued, issued + days(4)), rising_plus(more));
  };
  run(-12, 1);
  run(-6, 2);
  run(6, 3);
  run(36, 4);
  return sea;
}

/// Of a run that takes over at an hour: how much of the difference to the one before is left.
double left_of_join(double hours_since) { return std::max(0.0, 1 - hours_since / 6); }

TEST(HorizonWind, ForecastSeesTheNewestRunIssuedByTheEndOfTheDay) {
  const KnownSeriesForTests sea = analysed_and_forecast();
  const HorizonWind wind =
      horizon_wind(sea.data.wind, WindPolicy::forecast, end_of_day, stamps_to(72));
  ASSERT_EQ(wind.wind_m_s.size(), 73u);
  EXPECT_EQ(wind.wind_m_s[0], rising(end_of_day, 0)) << "analysed up to the end of D";
  EXPECT_EQ(wind.source[0], DataStatus::analysis);
  for (std::size_t h = 1; h < 73; ++h) {
    const double more = 2 - 2 * left_of_join(double(h));  // from the analysis onto the run
    EXPECT_NEAR(std::abs(wind.wind_m_s[h] - rising(end_of_day + hours(h), 0) - more), 0, 1e-12);
    EXPECT_EQ(wind.source[h], DataStatus::forecast);
  }
}

TEST(HorizonWind, ForecastNeverSeesWhatWasNotYetKnown) {
  const KnownSeriesForTests sea = analysed_and_forecast();
  ColumnData spoilt = sea.data;
  spoil_after(spoilt, end_of_day, end_of_day);
  const auto made = [&](const ColumnData& data) {
    return horizon_wind(data.wind, WindPolicy::forecast, end_of_day, stamps_to(72));
  };
  EXPECT_EQ(made(sea.data).wind_m_s, made(spoilt).wind_m_s);
  EXPECT_EQ(made(sea.data).series->value, made(spoilt).series->value);
}

TEST(HorizonWind, BestTakesLaterAnalysisAndTheNewestRunAndSaysWhichIsWhich) {
  const KnownSeriesForTests sea = analysed_and_forecast();
  const HorizonWind wind = horizon_wind(sea.data.wind, WindPolicy::best, end_of_day, stamps_to(72));
  for (std::size_t h = 0; h < 73; ++h) {
    const bool analysed = h <= 24;
    // The run of +6 h leaves the analysis and meets the newest, of +36 h.
    const double more = analysed ? 0
                        : h >= 36
                            ? 4
                            : 3 - 3 * left_of_join(double(h) - 24) + left_of_join(36 - double(h));
    EXPECT_NEAR(std::abs(wind.wind_m_s[h] - rising(end_of_day + hours(h), 0) - more), 0, 1e-12)
        << h;
    EXPECT_EQ(wind.source[h], analysed ? DataStatus::analysis : DataStatus::forecast) << h;
  }
}

TEST(HorizonWind, BestOfAnIssueTimeIsWhatWasKnownThen) {
  const KnownSeriesForTests sea = analysed_and_forecast();
  const UtcTime issued = end_of_day + hours(5);
  ColumnData spoilt = sea.data;
  spoil_after(spoilt, issued, issued);
  const auto made = [&](const ColumnData& data) {
    return horizon_wind(data.wind, WindPolicy::best, end_of_day, stamps_to(72), {issued, false});
  };
  const HorizonWind wind = made(sea.data);
  EXPECT_FALSE(wind.hindsight);
  EXPECT_EQ(wind.wind_m_s, made(spoilt).wind_m_s);
  EXPECT_EQ(wind.series->value, made(spoilt).series->value);
  EXPECT_EQ(wind.source[5], DataStatus::analysis) << "the hours up to the issue time are known";
  EXPECT_NE(wind.source[6], DataStatus::analysis);
  EXPECT_TRUE(
      horizon_wind(sea.data.wind, WindPolicy::best, end_of_day, stamps_to(72), {issued, true})
          .hindsight);
}

TEST(HorizonWind, WhereAForecastEndsItsLastValueIsPersisted) {
  KnownSeriesForTests sea;
  sea.wind(forecast_of("wind", end_of_day - hours(6)), instants(end_of_day, end_of_day + days(1)),
           rising);
  const HorizonWind wind =
      horizon_wind(sea.data.wind, WindPolicy::forecast, end_of_day, stamps_to(48));
  const Horizontal last = rising(end_of_day + days(1), 0);
  const Horizontal mean = rising(end_of_day + hours(12), 0);
  for (std::size_t h = 0; h <= 24; ++h) EXPECT_EQ(wind.source[h], DataStatus::forecast);
  for (std::size_t h = 25; h <= 48; ++h) {
    EXPECT_EQ(wind.source[h], DataStatus::persisted);
    const Horizontal expected = mean + std::exp(-double(h - 24) / 24) * (last - mean);
    EXPECT_NEAR(std::abs(wind.wind_m_s[h] - expected), 0, 1e-12);
  }
}

TEST(HorizonWind, SixHourlyStampsAreJoinedByLines) {
  for (const int step_h : {6, 12}) {
    KnownSeriesForTests sea;
    sea.wind(analysis_of("wind"),
             instants(end_of_day - days(2), end_of_day + days(2), hours(step_h)), rising);
    const HorizonWind wind =
        horizon_wind(sea.data.wind, WindPolicy::best, end_of_day, stamps_to(48));
    for (std::size_t h = 0; h <= 48; ++h) {
      EXPECT_NEAR(std::abs(wind.wind_m_s[h] - rising(end_of_day + hours(h), 0)), 0, 1e-12) << h;
      EXPECT_EQ(wind.source[h], DataStatus::analysis);
    }
  }
}

TEST(HorizonWind, CalibrationSeesTheStoredWindAndThenTheStamps) {
  KnownSeriesForTests sea;
  sea.wind(analysis_of("wind"), instants(end_of_day - days(1), end_of_day - hours(3)), rising);
  const HorizonWind wind = horizon_wind(sea.data.wind, WindPolicy::best, end_of_day, stamps_to(5));
  ASSERT_TRUE(wind.series);
  const VectorColumn& series = *wind.series;
  ASSERT_EQ(series.times(), 22u + 6u);
  EXPECT_TRUE(std::is_sorted(series.time.begin(), series.time.end(),
                             [](const TimeCell& a, const TimeCell& b) { return a.end < b.end; }));
  for (std::size_t t = 0; t < 22; ++t)
    EXPECT_EQ(series.value[t], rising(series.time[t].centre(), 0));
  for (std::size_t h = 0; h < 6; ++h) {
    EXPECT_EQ(series.value[22 + h], wind.wind_m_s[h]);
    EXPECT_EQ(series.source[22 + h], DataStatus::persisted);
  }
  EXPECT_EQ(wind.origins.size(), 22u);
}

TEST(HorizonWind, AnInstrumentSpeaksOnlyWhereThereIsNoProduct) {
  KnownSeriesForTests sea;
  const auto always = instants(end_of_day - days(2), end_of_day + days(1));
  sea.wind(station_of("mast", 9), always, rising_plus(5));
  const auto first = [&] {
    return horizon_wind(sea.data.wind, WindPolicy::best, end_of_day, stamps_to(3)).wind_m_s[0];
  };
  EXPECT_EQ(first(), rising(end_of_day, 0) + 5.0);
  sea.wind(analysis_of("wind", 1), always, rising);
  EXPECT_EQ(first(), rising(end_of_day, 0));
}

TEST(HorizonWind, AGapInsideTheHorizonIsNamedAndTheValueAfterItIsNotCopiedIntoIt) {
  KnownSeriesForTests sea;
  sea.wind(analysis_of("wind"), instants(end_of_day - days(4), end_of_day + days(1)),
           steady({5, 0}));
  sea.wind(analysis_of("wind", 2), instants(end_of_day + days(2), end_of_day + days(3)),
           steady({-9, 12}));
  const HorizonWind wind = horizon_wind(sea.data.wind, WindPolicy::best, end_of_day, stamps_to(72));
  ASSERT_EQ(wind.gaps.size(), 1u);
  EXPECT_EQ(wind.gaps[0], (WindGap{end_of_day + days(1), end_of_day + days(2)}));
  EXPECT_EQ(count(wind.source, DataStatus::persisted), 23u);
  for (std::size_t h = 25; h <= 42; ++h)
    EXPECT_NEAR(std::abs(wind.wind_m_s[h] - Horizontal(5, 0)), 0, 1e-12) << h;
  for (std::size_t h = 43; h < 48; ++h) {
    const double back = (double(h) - 42) / 6;
    EXPECT_NEAR(
        std::abs(wind.wind_m_s[h] - ((1 - back) * Horizontal(5, 0) + back * Horizontal(-9, 12))), 0,
        1e-12)
        << h;
  }
  EXPECT_EQ(wind.wind_m_s[48], Horizontal(-9, 12));
  EXPECT_EQ(wind.extra_sigma_m_s[24], 0);
  EXPECT_GT(wind.extra_sigma_m_s[47], wind.extra_sigma_m_s[30]);
  EXPECT_EQ(wind.extra_sigma_m_s[48], 0);
}

TEST(HorizonWind, WindBroughtFromAnotherHeightIsTheLessCertain) {
  KnownSeriesForTests sea;
  sea.wind(analysis_of("wind"), instants(end_of_day - days(1), end_of_day + days(3)),
           steady({9, 12}));
  sea.data.wind.pieces[0].from_height_m = 100;
  const HorizonWind wind = horizon_wind(sea.data.wind, WindPolicy::best, end_of_day, stamps_to(24));
  const double share = 0.06 * std::log(10.0);
  EXPECT_NEAR(wind.extra_sigma_m_s[5], 15 * share / std::sqrt(2.0), 1e-12);
  EXPECT_EQ(wind.stretches.at(0).from_height_m, 100);
}

TEST(HorizonWind, ForecastSeesWhatWasPublishedByTheIssueTime) {
  const KnownSeriesForTests sea = analysed_and_forecast();
  const HorizonWind wind =
      horizon_wind(sea.data.wind, WindPolicy::forecast, end_of_day, stamps_to(72),
                   {UtcTime::max(), false, end_of_day + hours(7)});
  EXPECT_EQ(wind.source[7], DataStatus::analysis);
  EXPECT_EQ(wind.source[8], DataStatus::forecast);
  EXPECT_NEAR(std::abs(wind.wind_m_s[20] - rising(end_of_day + hours(20), 0) - 3.0), 0, 1e-12)
      << "the run of +6 h";
}

TEST(HorizonWind, TurningTheWindTurnsIt) {
  const Horizontal by(0, 1);
  for (const WindPolicy policy : all_policies) {
    KnownSeriesForTests sea = analysed_and_forecast();
    const auto made = [&] {
      return horizon_wind(sea.data.wind, policy, end_of_day, stamps_to(200)).wind_m_s;
    };
    const std::vector<Horizontal> straight = made();
    turn(sea.data.wind, by);
    const std::vector<Horizontal> turned = made();
    for (std::size_t h = 0; h < straight.size(); ++h)
      EXPECT_NEAR(std::abs(turned[h] - by * straight[h]), 0, 1e-12) << h;
  }
}

/// Height linear in time; the waves turn from 350 to 10 degrees through north in the day after D.
void add_waves(KnownSeriesForTests& sea, const Origin& origin, const std::vector<TimeCell>& time,
               double more_m = 0) {
  sea.waves(
      origin, time, [=](UtcTime at) { return 2 + more_m + 0.01 * hours_between(end_of_day, at); },
      [](UtcTime) { return 7.0; },
      [](UtcTime at) { return hours_between(end_of_day, at) < 12 ? 350.0 : 10.0; });
}

HorizonSea sea_of(const ColumnData& data, WindPolicy policy, const std::vector<UtcTime>& stamps,
                  std::optional<double> fetch_km = std::nullopt) {
  Site site;
  if (fetch_km) site.fetch = Fetch(*fetch_km * 1000);
  return horizon_sea(data, site, policy, end_of_day, stamps,
                     horizon_wind(data.wind, policy, end_of_day, stamps));
}

TEST(HorizonSea, IsEmptyWithoutWavesAndWind) {
  const KnownSeriesForTests nothing;
  const HorizonSea sea = sea_of(nothing.data, WindPolicy::best, stamps_to(24));
  EXPECT_TRUE(sea.sea.empty());
  EXPECT_TRUE(sea.source.empty());
}

TEST(HorizonSea, StoredWavesAreServedAsTheyAre) {
  KnownSeriesForTests known;
  add_waves(known, analysis_of("waves"), instants(end_of_day, end_of_day + days(1), hours(3)));
  const HorizonSea sea = sea_of(known.data, WindPolicy::best, stamps_to(24));
  ASSERT_EQ(sea.sea.size(), 25u);
  EXPECT_EQ(count(sea.source, DataStatus::analysis), 25u);
  for (std::size_t h = 0; h < 25; ++h) {
    EXPECT_NEAR(sea.sea[h].significant_height_m, 2 + 0.01 * double(h), 1e-12);
    EXPECT_NEAR(sea.sea[h].peak_period_s, 7, 1e-12);
  }
  EXPECT_NEAR(sea.sea[9].from_direction_deg, 350, 1e-9);
  EXPECT_NEAR(sea.sea[12].from_direction_deg, 10, 1e-9);
  const double between = sea.sea[10].from_direction_deg;
  EXPECT_TRUE(between > 350 || between < 10) << "through north, not through south: " << between;
}

TEST(HorizonSea, WhatWasNotYetKnownIsNotSeen) {
  KnownSeriesForTests known = analysed_and_forecast();
  add_waves(known, analysis_of("waves"), instants(end_of_day - days(1), end_of_day + days(2)));
  add_waves(known, forecast_of("waves", end_of_day - hours(6)),
            instants(end_of_day - hours(6), end_of_day + hours(30)), 1);
  add_waves(known, forecast_of("waves", end_of_day + hours(6)),
            instants(end_of_day + hours(6), end_of_day + hours(60)), 2);
  const auto heights = [&](const ColumnData& data, WindPolicy policy) {
    std::vector<double> height;
    for (const SeaState& state : sea_of(data, policy, stamps_to(72)).sea)
      height.push_back(state.significant_height_m);
    return height;
  };
  ColumnData spoilt = known.data;
  spoil_after(spoilt, end_of_day, end_of_day);
  EXPECT_EQ(heights(known.data, WindPolicy::forecast), heights(spoilt, WindPolicy::forecast));
  EXPECT_NEAR(heights(spoilt, WindPolicy::forecast)[10], 3.1, 1e-12) << "the run that was issued";
  spoil_all_after(spoilt, end_of_day);
  EXPECT_EQ(heights(known.data, WindPolicy::persist), heights(spoilt, WindPolicy::persist));
}

TEST(HorizonSea, BestTakesLaterAnalysis) {
  KnownSeriesForTests known = analysed_and_forecast();
  add_waves(known, analysis_of("waves"), instants(end_of_day - days(1), end_of_day + hours(12)));
  add_waves(known, forecast_of("waves", end_of_day + hours(6)),
            instants(end_of_day + hours(6), end_of_day + hours(60)), 2);
  const HorizonSea sea = sea_of(known.data, WindPolicy::best, stamps_to(48));
  EXPECT_EQ(count(sea.source, DataStatus::analysis), 13u);
  EXPECT_EQ(count(sea.source, DataStatus::forecast), 36u);
  EXPECT_NEAR(sea.sea[12].significant_height_m, 2.12, 1e-12);
  EXPECT_NEAR(sea.sea[13].significant_height_m, 4.13 - 2 * left_of_join(1), 1e-12);
  EXPECT_NEAR(sea.sea[18].significant_height_m, 4.18, 1e-12);
}

TEST(HorizonSea, BeyondTheStoredWavesTheWindCarriesTheLastOfThemOn) {
  KnownSeriesForTests known;
  known.wind(analysis_of("wind"), instants(end_of_day - days(2), end_of_day + days(3)), rising);
  add_waves(known, analysis_of("waves"), instants(end_of_day - days(1), end_of_day + hours(10)));
  const std::vector<UtcTime> stamps = stamps_to(48);
  const HorizonSea sea = sea_of(known.data, WindPolicy::best, stamps, 80.0);
  ASSERT_EQ(sea.sea.size(), 49u);
  EXPECT_EQ(sea.source[10], DataStatus::analysis);
  std::vector<Horizontal> wind;
  for (std::size_t h = 10; h <= 48; ++h) wind.push_back(rising(stamps[h], 0));
  WaveSetting setting;
  setting.fetch = Fetch(80000);
  setting.water_depth_m = known.data.water_depth.depth_m;
  const std::vector<SeaState> grown = propagate_sea_state(sea.sea[10], wind, setting);
  for (std::size_t h = 11; h <= 48; ++h) {
    EXPECT_NEAR(sea.sea[h].significant_height_m, grown[h - 10].significant_height_m, 1e-9) << h;
    EXPECT_EQ(sea.source[h], DataStatus::modelled);
  }
}

TEST(HorizonSea, ALastKnownSeaBeforeTheHorizonIsCarriedUpToItFirst) {
  KnownSeriesForTests known;
  known.wind(analysis_of("wind"), instants(end_of_day - days(3), end_of_day + days(1)), steady({}));
  add_waves(known, analysis_of("waves"), instants(end_of_day - days(2), end_of_day - hours(24)));
  const HorizonSea sea = sea_of(known.data, WindPolicy::best, stamps_to(24));
  // No wind: the waves are swell whose energy falls by e in 24 h.
  const double last_m = 2 - 0.24;
  for (std::size_t h = 0; h <= 24; ++h) {
    EXPECT_NEAR(sea.sea[h].significant_height_m, last_m * std::exp(-(24 + double(h)) / 48), 1e-9)
        << h;
    EXPECT_EQ(sea.source[h], DataStatus::modelled);
  }
}

TEST(HorizonSea, WithoutAnyWavesTheWindRaisesASeaUpToItsFetch) {
  KnownSeriesForTests known;
  known.wind(analysis_of("wind"), instants(end_of_day - days(1), end_of_day + days(3)),
             steady({9, -4}));
  const double speed = std::abs(Horizontal(9, -4));
  double shorter = 0;
  for (const double fetch_km : {5.0, 50.0, 200.0}) {
    const HorizonSea sea = sea_of(known.data, WindPolicy::best, stamps_to(72), fetch_km);
    ASSERT_EQ(sea.sea.size(), 73u);
    const WindSea full = fetch_limited_sea(speed, fetch_km * 1000, 30);
    // The growth law is integrated by the hour: a percent of the limit.
    EXPECT_NEAR(sea.sea.back().significant_height_m, full.significant_height_m,
                0.01 * full.significant_height_m);
    EXPECT_GT(sea.sea.back().significant_height_m, shorter);
    EXPECT_NEAR(sea.sea.back().from_direction_deg, from_direction_deg({9, -4}), 1e-9);
    for (std::size_t h = 1; h < sea.sea.size(); ++h) {
      EXPECT_GE(sea.sea[h].significant_height_m, sea.sea[h - 1].significant_height_m - 1e-9);
    }
    shorter = sea.sea.back().significant_height_m;
  }
}

TEST(HorizonSea, ACalmWindRaisesCalmWaterAndSaysThatItIsComputed) {
  for (const double speed : {0.0, 0.1, 0.49}) {
    for (const int history_h : {0, 1, 100}) {
      KnownSeriesForTests known;
      known.wind(analysis_of("wind"), instants(end_of_day - hours(history_h), end_of_day + days(3)),
                 steady({speed, 0}));
      const HorizonSea sea = sea_of(known.data, WindPolicy::best, stamps_to(72));
      ASSERT_EQ(sea.sea.size(), 73u);
      for (const SeaState& state : sea.sea) {
        EXPECT_EQ(state.significant_height_m, 0.0);
        EXPECT_TRUE(std::isfinite(state.peak_period_s) && std::isfinite(state.from_direction_deg))
            << "a sea without a number would be served as missing";
      }
      EXPECT_EQ(count(sea.source, DataStatus::modelled), 73u);
      EXPECT_TRUE(sea.origins.empty()) << "no product gave them";
    }
  }
}

TEST(HorizonSea, ACalmFirstHourIsNoTroubleWhereTheWindComesLater) {
  KnownSeriesForTests known;
  known.wind(analysis_of("wind"), instants(end_of_day, end_of_day + days(3)),
             [](UtcTime time, double) {
               return hours_between(end_of_day, time) < 3 ? Horizontal(0.2, 0) : Horizontal(10, 0);
             });
  const HorizonSea sea = sea_of(known.data, WindPolicy::best, stamps_to(48));
  EXPECT_EQ(sea.sea[0].significant_height_m, 0.0);
  EXPECT_NEAR(sea.sea[48].significant_height_m,
              fetch_limited_sea(10, 200e3, 30).significant_height_m, 0.02);
}

TEST(HorizonSea, ALullAtTheFirstHourDoesNotWipeOutTheSeaOfTheGaleBefore) {
  // Ten hours of calm after a day of 15 m/s: swell whose energy falls by e in 24 h.
  KnownSeriesForTests known;
  known.wind(analysis_of("wind"), instants(end_of_day - days(2), end_of_day + days(1)),
             [](UtcTime time, double) {
               return hours_between(end_of_day, time) < -10 ? Horizontal(15, 0)
                                                            : Horizontal(0.1, 0);
             });
  const HorizonSea sea = sea_of(known.data, WindPolicy::best, stamps_to(24));
  const double gale_m = fetch_limited_sea(15, 200e3, 30).significant_height_m;
  EXPECT_NEAR(sea.sea[0].significant_height_m, gale_m * std::exp(-10.0 / 48), 0.05 * gale_m);
}

TEST(HorizonSea, TheSameWindFromTheLandAndFromTheSeaRaisesWavesOfTheirFetch) {
  Site site;
  site.fetch = Fetch({{200, 320, 400e3}, {320, 200, 5e3}});
  const auto last = [&](double from_deg) {
    KnownSeriesForTests known;
    known.wind(analysis_of("wind"), instants(end_of_day - days(2), end_of_day + days(3)),
               steady(vector_from_direction(13, from_deg)));
    const HorizonWind wind =
        horizon_wind(known.data.wind, WindPolicy::best, end_of_day, stamps_to(72));
    return horizon_sea(known.data, site, WindPolicy::best, end_of_day, stamps_to(72), wind)
        .sea.back()
        .significant_height_m;
  };
  EXPECT_NEAR(last(270), fetch_limited_sea(13, 400e3, 30).significant_height_m, 0.02);
  EXPECT_NEAR(last(90), fetch_limited_sea(13, 5e3, 30).significant_height_m, 0.005);
  EXPECT_GT(last(270), 3 * last(90));
}

TEST(HorizonSea, WithoutWindTheLastKnownSeaStaysAndIsCalledPersisted) {
  KnownSeriesForTests known;
  add_waves(known, analysis_of("waves"), instants(end_of_day - days(1), end_of_day + hours(2)));
  const HorizonSea sea = sea_of(known.data, WindPolicy::best, stamps_to(24));
  ASSERT_EQ(sea.sea.size(), 25u);
  EXPECT_EQ(count(sea.source, DataStatus::persisted), 22u);
  for (std::size_t h = 3; h <= 24; ++h) EXPECT_NEAR(sea.sea[h].significant_height_m, 2.02, 1e-12);
}

TEST(HorizonSea, WavesOfLongAgoAreNotASeaOfNow) {
  KnownSeriesForTests known;
  add_waves(known, analysis_of("waves"), instants(end_of_day - days(5), end_of_day - hours(49)));
  const HorizonSea sea = sea_of(known.data, WindPolicy::best, stamps_to(3));
  ASSERT_EQ(sea.sea.size(), 4u);
  for (const SeaState& state : sea.sea)
    EXPECT_TRUE(std::isnan(state.significant_height_m)) << "unknown, not calm";
}

}  // namespace
}  // namespace slackwater::calibration
