#include "fields/wave/growth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"

namespace slackwater::growth_test {
namespace {

constexpr double g = constants::gravity_m_s2;
constexpr double deep_m = 1.0e5;
constexpr double endless_m = 1.0e9;

TEST(FetchLimitedSea, JoinsKahmaAndCalkoenAtShortFetch) {
  // Kahma & Calkoen (1992), composite: 4 sqrt(5.2e-7 X*^0.9) and 2 pi/13.7 X*^0.27; the two fits
  // differ by less than 3 % where both hold.
  for (const double u : {6.0, 12.0, 20.0})
    for (const double x : {100.0, 500.0, 2000.0}) {
      const WindSea sea = fetch_limited_sea(u, x * u * u / g, deep_m);
      EXPECT_NEAR(
          sea.significant_height_m * g / (u * u) / (4 * std::sqrt(5.2e-7 * std::pow(x, 0.9))), 1.0,
          0.03);
      EXPECT_NEAR(sea.peak_period_s * g / u / (2 * constants::pi / 13.7 * std::pow(x, 0.27)), 1.0,
                  0.03);
    }
}

TEST(FetchLimitedSea, EndsInAFullyDevelopedSea) {
  // Pierson & Moskowitz (1964) by U10: 0.24 U^2/g, T = 7.69 U/g by the asymptotes of the formula.
  const WindSea sea = fetch_limited_sea(10.0, endless_m, deep_m);
  EXPECT_NEAR(sea.significant_height_m, 0.24 * 100.0 / g, 1e-6);
  EXPECT_NEAR(sea.peak_period_s, 7.69 * 10.0 / g, 1e-6);
}

TEST(FetchLimitedSea, ScalesWithTheSquareOfTheWindAtEqualDimensionlessFetch) {
  const WindSea a = fetch_limited_sea(7.0, 40e3, 30.0);
  const WindSea b = fetch_limited_sea(14.0, 4 * 40e3, 4 * 30.0);
  EXPECT_NEAR(b.significant_height_m, 4 * a.significant_height_m, 1e-12);
  EXPECT_NEAR(b.peak_period_s, 2 * a.peak_period_s, 1e-12);
}

TEST(FetchLimitedSea, GrowsWithWindFetchAndDepth) {
  Rng random(3, "wave/growth");
  for (int i = 0; i < 500; ++i) {
    const double u = random.uniform(1, 30);
    const double x = std::exp(random.uniform(std::log(500.0), std::log(2e6)));
    const double d = std::exp(random.uniform(std::log(3.0), std::log(500.0)));
    const double h = fetch_limited_sea(u, x, d).significant_height_m;
    EXPECT_GE(fetch_limited_sea(u * 1.1, x, d).significant_height_m, h);
    EXPECT_GE(fetch_limited_sea(u, x * 1.1, d).significant_height_m, h * (1 - 1e-12));
    EXPECT_GE(fetch_limited_sea(u, x, d * 1.1).significant_height_m, h * (1 - 1e-12));
    EXPECT_LE(h, steepest_height_m(fetch_limited_sea(u, x, d).peak_period_s) * (1 + 1e-12));
    EXPECT_LT(h, d);  // a wind sea does not fill the water column
  }
}

TEST(FetchLimitedSea, CalmRaisesNothingAndNonsenseIsRefused) {
  EXPECT_EQ(fetch_limited_sea(0.2, 1e5, 30).significant_height_m, 0.0);
  EXPECT_THROW((void)fetch_limited_sea(5, 0, 30), ContractViolation);
  EXPECT_THROW((void)fetch_limited_sea(5, 1e5, std::nan("")), ContractViolation);
}

TEST(FetchAfter, TravelsWithTheEnergyOfADeepWaterSea) {
  // At short fetch Tp = c X^m, so dX/dt = k X^m has X = [(1 - m) k t]^(1/(1-m)); m = 0.27115, c
  // from the formula.
  const double u = 10.0;
  const double m = 1.45 * 0.187;
  const double c = 7.69 * std::pow(2.77e-7, 0.187) * u / g * std::pow(g / (u * u), m);
  const double k = g * 0.903 / (4 * constants::pi) * c;
  const double exact_m = std::pow((1 - m) * k * 7200.0, 1 / (1 - m));
  // It starts at 10 m instead of 0 (half a minute) and tanh bends by 1 %.
  EXPECT_NEAR(fetch_after(u, 0, 7200.0, deep_m) / exact_m, 1.0, 0.03);
}

TEST(FetchAfter, HeightsAfterADurationAreThoseOfTheCoastalEngineeringManualWithinASixth) {
  // USACE (2002), II-2-35: t = 77.23 X^0.67/(U^0.34 g^0.33), deep water. It travels slower: 19 to
  // 37 % in fetch.
  for (const double u : {8.0, 15.0})
    for (const double x : {20e3, 100e3}) {
      const double t_s = 77.23 * std::pow(x, 0.67) / (std::pow(u, 0.34) * std::pow(g, 0.33));
      const double ours = limited_wind_sea(u, endless_m, t_s, deep_m).significant_height_m;
      EXPECT_NEAR(ours / fetch_limited_sea(u, x, deep_m).significant_height_m, 1.0, 1.0 / 6.0)
          << u << ' ' << x;
    }
}

TEST(FetchAfter, TwoHoursAreOneHourTwice) {
  const double once = fetch_after(12, 5e3, 7200, 40);
  EXPECT_DOUBLE_EQ(once, fetch_after(12, fetch_after(12, 5e3, 3600, 40), 3600, 40));
}

TEST(LimitedWindSea, LongDurationIsTheFetchLimit) {
  EXPECT_EQ(limited_wind_sea(12, 100e3, 1e6, 40).significant_height_m,
            fetch_limited_sea(12, 100e3, 40).significant_height_m);
  EXPECT_LT(limited_wind_sea(12, 100e3, 3600, 40).significant_height_m,
            0.6 * fetch_limited_sea(12, 100e3, 40).significant_height_m);
}

TEST(LimitedWindSea, CalmRaisesNothingHoweverLongItLasts) {
  for (const double speed : {0.0, 0.2, 0.49})
    for (const double duration_s : {0.0, 3600.0, 43200.0}) {
      const WindSea sea = limited_wind_sea(speed, 200e3, duration_s, 30);
      EXPECT_EQ(sea.significant_height_m, 0.0) << speed << " m/s, " << duration_s << " s";
      EXPECT_EQ(sea.peak_period_s, 0.0);
    }
  EXPECT_THROW((void)limited_wind_sea(std::nan(""), 200e3, 3600, 30), ContractViolation)
      << "unknown is not calm";
}

TEST(SteepestHeight, IsOneFifteenthShortAndOneTwentyFifthLong) {
  const auto steepness = [](double t) {
    return 2 * constants::pi * steepest_height_m(t) / (g * t * t);
  };
  EXPECT_NEAR(steepness(4), 1.0 / 15, 1e-12);
  EXPECT_NEAR(steepness(8), 1.0 / 15, 1e-12);
  EXPECT_NEAR(steepness(11.5), 0.5 * (1.0 / 15 + 1.0 / 25), 1e-12);
  EXPECT_NEAR(steepness(18), 1.0 / 25, 1e-12);
}

std::vector<Horizontal> steady(Horizontal wind, std::size_t hours) {
  return std::vector<Horizontal>(hours + 1, wind);
}

TEST(PropagateSeaState, WithoutWindTheEnergyDecaysExponentially) {
  const WaveSetting setting{.water_depth_m = 30, .swell_decay_h = 20};
  const auto sea = propagate_sea_state({3.0, 10.0, 250.0}, steady(0.0, 40), setting);
  ASSERT_EQ(sea.size(), 41u);
  for (std::size_t i = 0; i < sea.size(); ++i) {
    const double energy = 9.0 * std::exp(-static_cast<double>(i) / 20.0);
    EXPECT_NEAR(sea[i].significant_height_m * sea[i].significant_height_m, energy, 1e-12);
    EXPECT_EQ(sea[i].peak_period_s, 10.0);
    EXPECT_EQ(sea[i].from_direction_deg, 250.0);
  }
}

TEST(PropagateSeaState, SteadyWindOnCalmWaterGrowsToTheFetchLimit) {
  const WaveSetting setting{.fetch = Fetch(100e3), .water_depth_m = 30};
  const Horizontal wind = vector_from_direction(14.0, 230.0);
  const auto sea = propagate_sea_state({0.0, 0.0, 0.0}, steady(wind, 30), setting);
  for (std::size_t i = 2; i < sea.size(); ++i)
    EXPECT_GE(sea[i].significant_height_m, sea[i - 1].significant_height_m);
  const WindSea limit = fetch_limited_sea(14.0, 100e3, 30);
  EXPECT_NEAR(sea.back().significant_height_m, limit.significant_height_m, 1e-9);
  EXPECT_NEAR(sea.back().peak_period_s, limit.peak_period_s, 1e-9);
  EXPECT_NEAR(sea.back().from_direction_deg, 230.0, 1e-9);
  // Hour by hour it is the duration-limited growth of one go.
  EXPECT_NEAR(sea[3].significant_height_m,
              limited_wind_sea(14.0, 100e3, 3 * 3600.0, 30).significant_height_m, 1e-9);
}

TEST(PropagateSeaState, ASeaInBalanceWithItsWindStays) {
  const WaveSetting setting{.fetch = Fetch(150e3), .water_depth_m = 40};
  const WindSea limit = fetch_limited_sea(12.0, 150e3, 40);
  const auto sea = propagate_sea_state({limit.significant_height_m, limit.peak_period_s, 300.0},
                                       steady(vector_from_direction(12.0, 300.0), 24), setting);
  EXPECT_NEAR(sea.back().significant_height_m, limit.significant_height_m, 1e-6);
  EXPECT_NEAR(sea.back().peak_period_s, limit.peak_period_s, 1e-6);
}

TEST(PropagateSeaState, EnergiesOfSwellAndWindSeaAdd) {
  const WaveSetting setting{.fetch = Fetch(100e3), .water_depth_m = 50, .swell_decay_h = 24};
  const auto sea = propagate_sea_state({2.0, 13.0, 270.0},
                                       steady(vector_from_direction(10.0, 90.0), 6), setting);
  const double wind_sea = limited_wind_sea(10.0, 100e3, 6 * 3600.0, 50).significant_height_m;
  const double swell_energy = 4.0 * std::exp(-6.0 / 24.0);
  EXPECT_NEAR(sea.back().significant_height_m, std::sqrt(wind_sea * wind_sea + swell_energy), 1e-9);
  EXPECT_EQ(sea.back().from_direction_deg, 270.0);  // the swell still has the higher peak
}

TEST(PropagateSeaState, WhenTheWindDropsItsSeaBecomesSwellAndNoEnergyIsLost) {
  const WaveSetting setting{.fetch = Fetch(100e3), .water_depth_m = 50, .swell_decay_h = 1e9};
  std::vector<Horizontal> wind = steady(vector_from_direction(15.0, 200.0), 20);
  wind.resize(30, vector_from_direction(5.0, 200.0));
  const auto sea = propagate_sea_state({0.5, 4.0, 200.0}, wind, setting);
  for (std::size_t i = 21; i < sea.size(); ++i)
    EXPECT_NEAR(sea[i].significant_height_m, sea[20].significant_height_m, 1e-6);
}

TEST(PropagateSeaState, NeverSteeperThanWavesCanBe) {
  Rng random(8, "wave/steepness");
  const WaveSetting setting{.fetch = Fetch(50e3), .water_depth_m = 20};
  for (int i = 0; i < 50; ++i) {
    std::vector<Horizontal> wind;
    for (int h = 0; h < 48; ++h)
      wind.push_back(vector_from_direction(random.uniform(0, 28), random.uniform(0, 360)));
    const double period = random.uniform(3, 14);
    const SeaState last{random.uniform(0, steepest_height_m(period)), period,
                        random.uniform(0, 360)};
    for (const SeaState& sea : propagate_sea_state(last, wind, setting)) {
      if (sea.significant_height_m <= 0) continue;
      EXPECT_LE(sea.significant_height_m, steepest_height_m(sea.peak_period_s) * (1 + 1e-12));
    }
  }
}

TEST(PropagateSeaState, TheSameWindRaisesMoreFromTheSeaThanFromTheLand) {
  const WaveSetting setting{.fetch = Fetch({{200, 320, 400e3}, {320, 200, 5e3}}),
                            .water_depth_m = 30};
  const auto after = [&](double from_deg) {
    const Horizontal wind = vector_from_direction(14.0, from_deg);
    return propagate_sea_state({0.0, 0.0, 0.0}, steady(wind, 60), setting).back();
  };
  EXPECT_NEAR(after(270).significant_height_m,
              fetch_limited_sea(14, 400e3, 30).significant_height_m, 1e-6);
  EXPECT_NEAR(after(90).significant_height_m, fetch_limited_sea(14, 5e3, 30).significant_height_m,
              1e-9);
}

TEST(PropagateSeaState, AWindThatTurnsOffTheLandStartsAgainAndTheOldSeaIsSwell) {
  const WaveSetting setting{.fetch = Fetch({{180, 360, 300e3}, {0, 180, 2e3}}),
                            .water_depth_m = 30};
  std::vector<Horizontal> wind = steady(vector_from_direction(12, 270), 30);
  wind.resize(54, vector_from_direction(12, 90));
  const auto sea = propagate_sea_state({0.0, 0.0, 0.0}, wind, setting);
  for (std::size_t i = 32; i < sea.size(); ++i)
    EXPECT_LT(sea[i].significant_height_m, sea[i - 1].significant_height_m);
  EXPECT_GT(sea[31].significant_height_m, 0.95 * sea[30].significant_height_m)
      << "waves do not stop with their wind";
}

TEST(PropagateSeaState, WhatIsUnknownStaysUnknown) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const WaveSetting setting{.water_depth_m = 30};
  std::vector<Horizontal> wind = steady(vector_from_direction(8.0, 10.0), 5);
  for (const SeaState& sea : propagate_sea_state({nan, 8.0, 10.0}, wind, setting))
    EXPECT_TRUE(std::isnan(sea.significant_height_m));
  wind[3] = Horizontal(nan, 0.0);
  const auto sea = propagate_sea_state({1.0, 8.0, 10.0}, wind, setting);
  EXPECT_FALSE(std::isnan(sea[2].significant_height_m));
  EXPECT_TRUE(std::isnan(sea[3].significant_height_m));
  EXPECT_TRUE(std::isnan(sea[5].significant_height_m));
}

}  // namespace
}  // namespace slackwater::growth_test
