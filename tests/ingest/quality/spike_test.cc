#include "ingest/quality/spike.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"

namespace slackwater::ingest::spike_test {
namespace {

using constants::pi;
using enum SampleStatus;

/// A current that turns with the tide, strength and direction, with noise of an instrument.
struct TidalStream {
  std::vector<UtcTime> times;
  std::vector<float> east;
  std::vector<float> north;
  std::vector<SampleStatus> east_status;
  std::vector<SampleStatus> north_status;

  TidalStream(double amplitude_m_s, double step_h, std::size_t count, double noise_m_s = 0.03) {
    Rng rng(7, "tests/spike");
    for (std::size_t i = 0; i < count; ++i) {
      const double hours = step_h * static_cast<double>(i);
      const double phase = 2 * pi * hours / 12.4206;
      times.push_back(add_hours(parse_utc("2024-03-10T00:00:00Z"), hours));
      east.push_back(
          static_cast<float>(amplitude_m_s * std::cos(phase) + noise_m_s * rng.normal()));
      north.push_back(
          static_cast<float>(0.3 * amplitude_m_s * std::sin(phase) + noise_m_s * rng.normal()));
    }
    east_status.assign(count, not_checked);
    north_status.assign(count, not_checked);
  }
  std::size_t test() {
    return test_vector_spikes(*spike_threshold_of("eastward_sea_water_velocity"), times, east,
                              north, east_status, north_status);
  }
};

TEST(SpikeTest, LeavesTheStrongestTidalStreamsAlone) {
  for (const double amplitude : {0.1, 1.0, 2.5, 5.0}) {
    for (const double step_h : {1.0 / 6, 0.5, 1.0, 3.0, 6.0}) {
      TidalStream stream(amplitude, step_h, 300);
      EXPECT_EQ(stream.test(), 0U) << amplitude << " m/s every " << step_h << " h";
    }
  }
}

TEST(SpikeTest, FindsALoneSpikeAndMarksBothComponents) {
  TidalStream stream(1.0, 1.0, 200);
  stream.north[77] += 4.0F;
  EXPECT_EQ(stream.test(), 1U);
  EXPECT_EQ(stream.east_status[77], suspect);
  EXPECT_EQ(stream.north_status[77], suspect);
  EXPECT_EQ(stream.north_status[76], not_checked);
  EXPECT_EQ(stream.north_status[78], not_checked);
}

TEST(SpikeTest, TurningTheAxesTurnsNothing) {
  for (const double turn : {0.3, 1.1, 2.9}) {
    TidalStream stream(1.0, 1.0, 200);
    stream.east[50] += 2.0F;
    stream.north[120] -= 2.0F;
    for (std::size_t i = 0; i < stream.east.size(); ++i) {
      const double u = stream.east[i];
      const double v = stream.north[i];
      stream.east[i] = static_cast<float>(u * std::cos(turn) - v * std::sin(turn));
      stream.north[i] = static_cast<float>(u * std::sin(turn) + v * std::cos(turn));
    }
    EXPECT_EQ(stream.test(), 2U);
    EXPECT_EQ(stream.east_status[50], suspect);
    EXPECT_EQ(stream.east_status[120], suspect);
  }
}

TEST(SpikeTest, NothingIsJudgedAcrossAGap) {
  TidalStream stream(0.1, 1.0, 100);
  for (std::size_t i = 60; i < 100; ++i) {  // another state of the sea after ten days without data
    stream.times[i] += std::chrono::hours(240);
    stream.east[i] += 3.0F;
  }
  EXPECT_EQ(stream.test(), 0U);
}

TEST(SpikeTest, MissingNeighboursAreSteppedOver) {
  TidalStream stream(0.5, 1.0, 100);
  stream.east[40] = stream.east[42] = std::nanf("");
  stream.east_status[40] = stream.east_status[42] = missing;
  stream.east[41] += 5.0F;
  EXPECT_EQ(stream.test(), 1U);
  EXPECT_EQ(stream.east_status[41], suspect);
}

TEST(SpikeTest, WhatAProviderPassedStays) {
  TidalStream stream(0.5, 1.0, 100);
  stream.east[41] += 5.0F;
  stream.east_status[41] = stream.north_status[41] = ok;
  EXPECT_EQ(stream.test(), 0U);
}

TEST(SpikeTest, ScalarsFollowTheSameRule) {
  std::vector<UtcTime> times;
  std::vector<float> height;
  for (int i = 0; i < 100; ++i) {
    times.push_back(parse_utc("2024-03-10T00:00:00Z") + std::chrono::minutes(10 * i));
    height.push_back(
        static_cast<float>(2.0 + 3.0 * std::exp(-std::pow((i - 50) / 12.0, 2)) + 0.05 * (i % 3)));
  }
  std::vector<SampleStatus> status(height.size(), not_checked);
  const double threshold = *spike_threshold_of("sea_surface_wave_significant_height");
  EXPECT_EQ(test_spikes(threshold, times, height, status), 0U);  // a storm comes and goes
  height[30] = 14.0F;
  EXPECT_EQ(test_spikes(threshold, times, height, status), 1U);
  EXPECT_EQ(status[30], suspect);
}

TEST(SpikeTest, ShortSeriesAreNotJudged) {
  TidalStream stream(0.1, 1.0, 6);
  stream.east[3] = 50.0F;
  EXPECT_EQ(stream.test(), 0U);
}

}  // namespace
}  // namespace slackwater::ingest::spike_test
