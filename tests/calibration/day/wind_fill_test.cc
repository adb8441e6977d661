#include "calibration/day/given/wind_fill.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "calibration/propagate/wind_error.h"
#include "fields/base/numbers/random.h"
#include "fields/current/stress_series.h"
#include "tests/support/known_series_for_tests.h"

namespace slackwater::calibration::wind_fill_test {
namespace {

using std::chrono::hours;
using namespace tests;

const UtcTime start = parse_utc("2024-06-12T00:00:00Z");

VectorColumn series_at(const std::vector<int>& at_h, const FlowForTests& flow) {
  VectorColumn series;
  for (const int h : at_h) {
    series.time.push_back(TimeCell::instant(start + hours(h)));
    series.value.push_back(flow(start + hours(h), 0));
    series.status.push_back(SampleStatus::ok);
    series.source.push_back(DataStatus::analysis);
  }
  return series;
}

std::vector<int> every(int step_h, int from_h, int to_h) {
  std::vector<int> at;
  for (int h = from_h; h <= to_h; h += step_h) at.push_back(h);
  return at;
}

std::vector<UtcTime> hourly(int to_h) {
  std::vector<UtcTime> stamps;
  for (int h = 0; h <= to_h; ++h) stamps.push_back(start + hours(h));
  return stamps;
}

Horizontal straight(UtcTime time, double) {
  return Horizontal(0.2, -0.1) * hours_between(start, time);
}

TEST(FillWind, TwelveHourlyValuesAreALineForStampsAndForTheStress) {
  const FilledWind filled = fill_wind(series_at(every(12, -24, 48), straight), hourly(48));
  EXPECT_TRUE(filled.gaps.empty());
  for (std::size_t h = 0; h <= 48; ++h) {
    EXPECT_NEAR(std::abs(filled.wind_m_s[h] - straight(start + hours(h), 0)), 0, 1e-12);
    EXPECT_EQ(filled.source[h], DataStatus::analysis);
    EXPECT_EQ(filled.hole_sigma_m_s[h], 0) << "its usual step";
  }
  EXPECT_EQ(filled.series.times(), 73u) << "hour by hour";
  const StressSeries stress(filled.series, {});
  for (int h = -24; h <= 48; ++h) EXPECT_TRUE(stress.at(start + hours(h))) << h;
}

TEST(FillWind, AHoleIsCrossedOnALineWithAWiderBandInTheMiddle) {
  std::vector<int> at = every(1, -24, 4);
  for (const int h : every(1, 12, 24)) at.push_back(h);
  const FilledWind filled = fill_wind(series_at(at, straight), hourly(24));
  EXPECT_TRUE(filled.gaps.empty());
  const WindErrorGrowth persisted = persisted_wind_error();
  for (std::size_t h = 0; h <= 24; ++h) {
    EXPECT_NEAR(std::abs(filled.wind_m_s[h] - straight(start + hours(h), 0)), 0, 1e-12);
    EXPECT_TRUE((h > 4 && h < 12) || filled.hole_sigma_m_s[h] == 0) << h;
  }
  EXPECT_NEAR(filled.hole_sigma_m_s[8], persisted.sigma_m_s(4) / std::sqrt(2.0), 1e-12)
      << "as far from both sides";
  EXPECT_LT(filled.hole_sigma_m_s[6], filled.hole_sigma_m_s[8]);
}

TEST(FillWind, NothingIsTakenFromBeyondAGap) {
  std::vector<int> at = every(1, -24, 10);
  const std::size_t known = at.size();
  for (const int h : every(1, 40, 60)) at.push_back(h);
  VectorColumn series = series_at(at, straight);
  const FilledWind before = fill_wind(series, hourly(60));
  for (std::size_t i = known; i < at.size(); ++i) series.value[i] += Horizontal(30, 40);
  const FilledWind after = fill_wind(series, hourly(60));
  for (std::size_t h = 0; h <= 34; ++h) EXPECT_EQ(before.wind_m_s[h], after.wind_m_s[h]) << h;
  EXPECT_NE(before.wind_m_s[36], after.wind_m_s[36]) << "on the way back";
  ASSERT_EQ(after.gaps.size(), 1u);
  EXPECT_EQ(after.gaps[0], (WindGap{start + hours(10), start + hours(40)}));
}

TEST(FillWind, BeforeTheFirstValueTheMeanThenTheWayToIt) {
  const FilledWind filled = fill_wind(series_at(every(1, 20, 30), steady({6, 2})), hourly(30));
  EXPECT_EQ(filled.source[0], DataStatus::persisted);
  ASSERT_EQ(filled.gaps.size(), 1u);
  EXPECT_EQ(filled.gaps[0], (WindGap{start, start + hours(20)}));
  EXPECT_EQ(filled.hole_sigma_m_s[3], wind_climate_sigma_m_s);
  EXPECT_EQ(filled.wind_m_s[25], Horizontal(6, 2));
}

TEST(FillWind, WhateverIsMissingTheWindStaysWithinWhatBlewAndJumpsNoMore) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Rng rng(seed, "tests/wind_fill");
    std::vector<int> at;
    for (int h = -48; h <= 72; ++h) {
      if (rng.uniform(0, 1) < 0.6) at.push_back(h);
      if (rng.uniform(0, 1) < 0.06) h += static_cast<int>(rng.uniform(0, 40));
    }
    if (at.empty()) continue;
    const auto wave = [](UtcTime time, double) {
      return std::polar(9.0, hours_between(start, time) / 9.0);
    };
    const FilledWind filled = fill_wind(series_at(at, wave), hourly(72));
    for (std::size_t h = 0; h <= 72; ++h) {
      EXPECT_LE(std::abs(filled.wind_m_s[h]), 9.0 + 1e-12) << "seed " << seed;
      if (h > 0) {
        // The way back over six hours from anywhere to anywhere.
        EXPECT_LE(std::abs(filled.wind_m_s[h] - filled.wind_m_s[h - 1]), 18.0 / 6 + 1.5)
            << "seed " << seed << " at " << h;
      }
    }
    const auto& time = filled.series.time;
    EXPECT_TRUE(std::is_sorted(time.begin(), time.end(), [](const auto& a, const auto& b) {
      return a.start <= b.start;
    })) << "strictly ascending";
  }
}

}  // namespace
}  // namespace slackwater::calibration::wind_fill_test
