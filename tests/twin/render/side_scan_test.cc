#include "twin/render/ranging/side_scan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "tests/twin/render/ranging_for_tests.h"

namespace slackwater::twin::side_scan_test {
namespace {

constexpr double far_m = 50;
constexpr double altitude_m = 8;

/// At the origin, the bow to the north.
const Pose& underway() {
  static const Pose pose = looking({0, 0, 0}, {1, 0, 0});
  return pose;
}

SideScanSheet sheet_of(int bins, int rays) {
  SideScanSheet sheet;
  sheet.beam_rad = 0.3 * constants::degree;
  sheet.upright_rad = 50 * constants::degree;
  sheet.depression_rad = 35 * constants::degree;
  sheet.rays = rays;
  sheet.bins = bins;
  sheet.absorption_db_m = 0.3;
  sheet.noise_floor = 0;
  return sheet;
}

SideScanPing ping_of(const Cast& cast, const SideScanSheet& sheet, int threads = 1,
                     std::uint64_t seed = 1) {
  return side_scanned(cast.scene, cast.caster, sheet, underway(), 0.5, far_m, seed, threads);
}

double sum_of_side(const SideScanPing& ping, ScanSide side) {
  double sum = 0;
  for (int bin = 0; bin < ping.bins; ++bin)
    sum += static_cast<double>(ping.mean[ping.place(side, bin)]);
  return sum;
}

TriangleMesh level_bed() { return level_mesh({-100, -100, altitude_m}, 10, 20, 20); }

// The bow to the north: west is port, east is starboard.
TEST(SideScan, PortIsPortAndStarboardIsStarboard) {
  TriangleMesh ball = sphere_mesh(0, 2, 40);
  ball.origin_m = {0, -15, 6};
  const SideScanPing port = ping_of(Cast(ball), sheet_of(512, 1024));
  EXPECT_GT(sum_of_side(port, ScanSide::port), 0);
  EXPECT_EQ(sum_of_side(port, ScanSide::starboard), 0);
  ball.origin_m.y = 15;
  const SideScanPing starboard = ping_of(Cast(ball), sheet_of(512, 1024));
  EXPECT_EQ(sum_of_side(starboard, ScanSide::port), 0);
  EXPECT_NEAR(sum_of_side(starboard, ScanSide::starboard) / sum_of_side(port, ScanSide::port), 1,
              1e-3);
  EXPECT_GT(side_scan_direction(underway(), ScanSide::starboard, 0.5, 0).y, 0);
  EXPECT_GT(side_scan_direction(underway(), ScanSide::starboard, 0.5, 0).z, 0);
}

/// mu w of the integral of sin(d) b^2(d - tilt) 10^(-2ar/10) / r^2 over the angles below the
/// horizon from which a level bed answers between two ranges.
double echo_of_level_bed(const SideScanSheet& sheet, double from_m, double to_m) {
  constexpr int steps = 200;
  const double steep = std::asin(std::min(1.0, altitude_m / from_m));
  const double flat = std::asin(std::min(1.0, altitude_m / to_m));
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double d = flat + (i + 0.5) / steps * (steep - flat), r = altitude_m / std::sin(d);
    const double off = 2 * (d - sheet.depression_rad) / sheet.upright_rad;
    sum += std::sin(d) * std::exp(-2 * std::log(2.0) * off * off) *
           std::pow(10.0, -2 * sheet.absorption_db_m * r / 10) / (r * r) * (steep - flat) / steps;
  }
  return std::pow(10.0, sheet.mackenzie_db / 10) * sheet.beam_rad * sum;
}

TEST(SideScan, EchoOfALevelBedIsItsClosedFormBinByBin) {
  const SideScanSheet sheet = sheet_of(500, 4096);
  const SideScanPing ping = ping_of(Cast(level_bed()), sheet);
  for (const ScanSide side : {ScanSide::port, ScanSide::starboard})
    for (int bin = 0; bin < sheet.bins; ++bin) {
      const double told = static_cast<double>(ping.mean[ping.place(side, bin)]);
      const double from_m = bin * ping.bin_m, to_m = from_m + ping.bin_m;
      if (to_m < altitude_m + 1e-9) {
        EXPECT_EQ(told, 0) << "open water above the bed, bin " << bin;
        continue;
      }
      // Next to straight down a bin holds some ten rays, and the bed is met all at once.
      const double tolerance = from_m < 1.05 * altitude_m ? 0.05 : 0.01;
      EXPECT_NEAR(told / echo_of_level_bed(sheet, std::max(from_m, altitude_m), to_m), 1, tolerance)
          << "bin " << bin;
      EXPECT_EQ(ping.instance[ping.place(side, bin)], 1);
    }
}

// However few rays and fine bins: a ray stands for all that lies between its neighbours.
TEST(SideScan, NoBinOfABedIsLeftOut) {
  const SideScanSheet sheet = sheet_of(4000, 128);
  const SideScanPing ping = ping_of(Cast(level_bed()), sheet);
  for (int bin = static_cast<int>(altitude_m / ping.bin_m) + 1; bin < sheet.bins; ++bin)
    EXPECT_GT(ping.mean[ping.place(ScanSide::port, bin)], 0) << bin;
  EXPECT_NEAR(sum_of_side(ping, ScanSide::port) / echo_of_level_bed(sheet, altitude_m, far_m), 1,
              0.02);
}

// Inside of a tube about the axis all rays are met squarely at one range: what comes back is the
// integral of the pattern alone.
TEST(SideScan, APatternOutAndInIsWhatATubeThrowsBack) {
  constexpr double radius_m = 12;
  TriangleMesh tube;
  constexpr std::uint32_t round = 720;
  for (std::uint32_t i = 0; i < round; ++i) {
    const double turn = 2 * constants::pi * i / round;
    for (const float x : {-5.0F, 5.0F})
      tube.corners.push_back({x, static_cast<float>(radius_m * std::cos(turn)),
                              static_cast<float>(radius_m * std::sin(turn))});
  }
  for (std::uint32_t i = 0; i < round; ++i) {
    const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % round);
    tube.triangles.push_back({a, a + 1, b});
    tube.triangles.push_back({b, a + 1, b + 1});
  }
  const SideScanSheet sheet = sheet_of(100, 4096);
  double pattern = 0;
  constexpr int steps = 20000;
  const double top = sheet.depression_rad - 1.5 * sheet.upright_rad,
               whole = constants::pi / 2 - top;
  for (int i = 0; i < steps; ++i) {
    const double off =
        2 * (top + (i + 0.5) / steps * whole - sheet.depression_rad) / sheet.upright_rad;
    pattern += std::exp(-2 * std::log(2.0) * off * off) * whole / steps;
  }
  const double expected = std::pow(10.0, -2.7) * sheet.beam_rad * pattern / (radius_m * radius_m) *
                          std::pow(10.0, -0.06 * radius_m);
  const SideScanPing ping = ping_of(Cast(tube), sheet);
  EXPECT_NEAR(sum_of_side(ping, ScanSide::port) / expected, 1, 1e-3);
  EXPECT_NEAR(sum_of_side(ping, ScanSide::starboard) / expected, 1, 1e-3);
}

// Similar triangles: what stands h high at a ground range x, seen from a altitude above the bed,
// hides the bed from x to x a/(a - h).
TEST(SideScan, AShadowIsAsLongAsSimilarTrianglesSay) {
  for (const double high_m : {1.0, 2.5, 4.0})
    for (const double away_m : {8.0, 15.0}) {
      const auto h = static_cast<float>(high_m);
      const TriangleMesh plate{{0, away_m, altitude_m},
                               {{-5, 0, -h}, {5, 0, -h}, {5, 0, 0}, {-5, 0, 0}},
                               {{0, 1, 2}, {0, 2, 3}}};
      const SideScanSheet sheet = sheet_of(1000, 8192);
      const SideScanPing ping = ping_of(Cast({level_bed(), plate}), sheet);
      const double ends_away_m = away_m * altitude_m / (altitude_m - high_m);
      const double begins_m = std::hypot(away_m, altitude_m);
      const double ends_m = std::hypot(ends_away_m, altitude_m);
      double shadow_m = 0;
      for (int bin = static_cast<int>(altitude_m / ping.bin_m) + 1; bin < sheet.bins; ++bin) {
        const std::size_t at = ping.place(ScanSide::starboard, bin);
        shadow_m += ping.mean[at] == 0 ? ping.bin_m : 0;
        EXPECT_EQ(ping.mean[at] == 0, ping.instance[at] == 0);
        EXPECT_GT(ping.mean[ping.place(ScanSide::port, bin)], 0) << "no shadow to port";
      }
      // At both ends half of a ray's step on the bed, and a bin that is lit in part.
      const double step_m = 20 * altitude_m / (0.75 * sheet.rays);
      if (ends_m < far_m) {
        EXPECT_NEAR(shadow_m, ends_m - begins_m, step_m + 2 * ping.bin_m)
            << high_m << " m high, " << away_m << " m off";
      }
      // The plate itself is laid over the bed before it, which port has alone.
      const double top_m = std::hypot(away_m, altitude_m - high_m);
      const int bin = static_cast<int>(0.5 * (top_m + begins_m) / ping.bin_m);
      EXPECT_GT(ping.mean[ping.place(ScanSide::starboard, bin)],
                1.1 * static_cast<double>(ping.mean[ping.place(ScanSide::port, bin)]));
    }
}

TEST(SideScan, SpeckleIsExponentialAndNoiseIsAsStated) {
  SideScanSheet sheet = sheet_of(500, 1024);
  const Cast cast(level_bed());
  double sum = 0, squares = 0, count = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const SideScanPing ping = ping_of(cast, sheet, 2, seed);
    for (std::size_t i = 0; i < ping.mean.size(); ++i) {
      if (!(ping.mean[i] > 0)) continue;
      const double share =
          static_cast<double>(ping.intensity[i]) / static_cast<double>(ping.mean[i]);
      sum += share;
      squares += share * share;
      ++count;
    }
  }
  EXPECT_GT(count, 5000);
  EXPECT_NEAR(sum / count, 1, 4 / std::sqrt(count));
  // The square of an exponential number has mean 2 and a standard deviation of 20^(1/2).
  EXPECT_NEAR(squares / count, 2, 4 * std::sqrt(20 / count));
  sheet.noise_floor = 1e-9;
  const SideScanPing noisy = ping_of(cast, sheet);
  double floor = 0, open = 0;
  for (std::size_t i = 0; i < noisy.mean.size(); ++i) {
    if (noisy.mean[i] > 0) continue;
    floor += static_cast<double>(noisy.intensity[i]);
    ++open;
  }
  EXPECT_NEAR(floor / open / 1e-9, 1, 4 / std::sqrt(open));
}

TEST(SideScan, IsTheSameOnAnyNumberOfThreadsAndInstructionSet) {
  TriangleMesh ball = sphere_mesh(0, 2, 40);
  ball.origin_m = {0, -15, 6};
  const SideScanSheet sheet = sheet_of(512, 1024);
  const SideScanPing one = ping_of(Cast({level_bed(), ball}), sheet, 1);
  for (const int threads : {2, 5}) {
    const SideScanPing more = ping_of(Cast({level_bed(), ball}, "isa=sse2"), sheet, threads);
    EXPECT_EQ(one.intensity, more.intensity);
    EXPECT_EQ(one.instance, more.instance);
  }
}

}  // namespace
}  // namespace slackwater::twin::side_scan_test
