#include <gtest/gtest.h>

#include <cmath>

#include "calibration/day/given/horizon.h"
#include "fields/wave/growth.h"
#include "tests/calibration/day/horizon_for_tests.h"

namespace slackwater::calibration::horizon_sea_test {
namespace {

using std::chrono::days;
using std::chrono::hours;
using namespace tests;

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
}  // namespace slackwater::calibration::horizon_sea_test
