#include "twin/render/ranging/multibeam.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "tests/twin/render/ranging_for_tests.h"
#include "twin/render/ranging/fan.h"

namespace slackwater::twin::multibeam_test {
namespace {

constexpr double far_m = 100;

MultibeamSheet fan() {
  MultibeamSheet sheet;
  sheet.beams = 512;
  sheet.across_rad = 2.0;
  sheet.noise_sd_m = 0.02;
  sheet.noise_per_range = 0.001;
  sheet.step_m = 0;
  sheet.noise_floor = 0;
  return sheet;
}

std::vector<Sounding> ping_of(const Cast& cast, const MultibeamSheet& sheet, std::uint64_t seed = 9,
                              double least_m = 0.5, double most_m = far_m, int threads = 1) {
  return sounded(cast.scene, cast.caster, sheet, looking_down(), least_m, most_m, seed, threads);
}

// The depth at a place y to the right is h + s y: along a beam t off straight down r = h / (cos t -
// s sin t). Level is s = 0.
TEST(Multibeam, DepthOfALevelAndOfASlopingBedIsWithinItsStatedNoise) {
  for (const double fall : {0.0, 0.2, -0.3}) {
    const Cast cast(sloping_mesh(15, fall));
    const auto soundings = ping_of(cast, fan());
    double squares = 0;
    for (const Sounding& one : soundings) {
      const double t = one.bearing_rad;
      const double range_m = 15 / (std::cos(t) - fall * std::sin(t));
      ASSERT_NEAR(one.true_range_m, range_m, 2e-5 * range_m);
      EXPECT_NEAR(one.true_place_m.z, 15 + fall * one.true_place_m.y, 2e-5 * range_m);
      const double sd_m = 0.02 + 0.001 * range_m;
      // The number of the noise is within 6 of its deviations.
      EXPECT_LT(std::abs(one.place_m.z - one.true_place_m.z), 6 * sd_m * std::cos(t) + 1e-5);
      squares += std::pow((one.range_m - range_m) / sd_m, 2) / 512;
      EXPECT_EQ(one.instance, 1);
    }
    EXPECT_NEAR(squares, 1, 4 * std::sqrt(2.0 / 512)) << fall;
  }
}

TEST(Multibeam, PortBeamsLookToPort) {
  const auto soundings = ping_of(Cast(sloping_mesh(15, 0)), fan());
  EXPECT_NEAR(soundings.front().bearing_rad, -1, 1e-12);
  EXPECT_LT(soundings.front().place_m.y, -20) << "west, the bow to the north";
  EXPECT_GT(soundings.back().place_m.y, 20);
  EXPECT_NEAR(
      beam_bearing_rad(fan().across_rad, 512, 256) - beam_bearing_rad(fan().across_rad, 512, 255),
      2.0 / 511, 1e-12);
}

// Var(depth) = (sd cos t)^2 + (h tan t bearing_sd)^2.
TEST(Multibeam, OuterBeamsAreWorseByTheirBearing) {
  MultibeamSheet sheet = fan();
  sheet.beams = 5;
  sheet.bearing_sd_rad = 0.2 * constants::degree;
  const Cast cast(sloping_mesh(15, 0));
  constexpr int pings = 2000;
  std::vector<double> squares(5, 0.0), sums(5, 0.0);
  for (std::uint64_t seed = 0; seed < pings; ++seed) {
    const auto soundings = ping_of(cast, sheet, seed);
    for (std::size_t i = 0; i < 5; ++i) {
      squares[i] += std::pow(soundings[i].place_m.z - 15, 2) / pings;
      sums[i] += (soundings[i].place_m.z - 15) / pings;
    }
  }
  for (int i = 0; i < 5; ++i) {
    const double t = beam_bearing_rad(sheet.across_rad, sheet.beams, i);
    const double sd_m = (0.02 + 0.001 * 15 / std::cos(t)) * std::cos(t);
    const double by_bearing_m = 15 * std::tan(t) * sheet.bearing_sd_rad;
    const double variance = sd_m * sd_m + by_bearing_m * by_bearing_m;
    const auto at = static_cast<std::size_t>(i);
    EXPECT_NEAR(squares[at] / variance, 1, 4 * std::sqrt(2.0 / pings)) << i;
    EXPECT_NEAR(sums[at], 0, 4 * std::sqrt(variance / pings)) << i;
    if (i == 0) {
      EXPECT_GT(by_bearing_m * by_bearing_m, 2 * sd_m * sd_m) << "else this shows nothing";
    }
  }
}

// mu W cos(t) 10^(-2ar/10) / r^2 over a level bed, r = h / cos t.
TEST(Multibeam, WhatIsTooFaintIsNotTold) {
  MultibeamSheet sheet = fan();
  sheet.absorption_db_m = 0.1;
  const auto level_of = [&](double t) {
    const double r = 15 / std::cos(t);
    return std::pow(10.0, -2.7) * sheet.beam_across_rad * sheet.beam_along_rad * std::cos(t) *
           std::pow(10.0, -0.02 * r) / (r * r);
  };
  sheet.noise_floor = level_of(0.7) / 10;  // 10 dB over it are told
  std::size_t told = 0;
  for (const Sounding& one : ping_of(Cast(sloping_mesh(15, 0)), sheet)) {
    EXPECT_NEAR(one.level / level_of(one.bearing_rad), 1, 1e-5);
    EXPECT_EQ(std::isfinite(one.range_m), std::abs(one.bearing_rad) < 0.7) << one.bearing_rad;
    EXPECT_TRUE(std::isfinite(one.true_range_m));
    told += std::isfinite(one.range_m) ? 1 : 0;
  }
  EXPECT_GT(told, 300U);
  EXPECT_LT(told, 400U);
}

TEST(Multibeam, OutsideOfTheGateNothingIsTold) {
  const Cast cast(sloping_mesh(15, 0));
  for (const Sounding& one : ping_of(cast, fan(), 1, 16, 20)) {
    const double range_m = 15 / std::cos(one.bearing_rad);
    if (std::abs(range_m - 16) < 0.3 || std::abs(range_m - 20) < 0.3) continue;
    EXPECT_EQ(std::isfinite(one.range_m), range_m > 16 && range_m < 20) << range_m;
    EXPECT_EQ(std::isfinite(one.true_range_m), range_m > 16 && range_m < 20) << range_m;
  }
  for (const Sounding& one : ping_of(Cast(sloping_mesh(150, 0)), fan())) {
    EXPECT_TRUE(std::isnan(one.range_m)) << "no bottom within reach";
    EXPECT_EQ(one.instance, 0);
  }
}

TEST(Multibeam, TellsWholeStepsAndTheSameOnAnyNumberOfThreads) {
  MultibeamSheet sheet = fan();
  sheet.step_m = 0.25;
  sheet.bearing_sd_rad = 0.001;
  const Cast cast(sloping_mesh(15, 0.1));
  const auto one = ping_of(cast, sheet), two = ping_of(cast, sheet, 9, 0.5, far_m, 2);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].range_m, two[i].range_m);
    EXPECT_EQ(std::remainder(one[i].range_m, 0.25F), 0);
  }
}

}  // namespace
}  // namespace slackwater::twin::multibeam_test
