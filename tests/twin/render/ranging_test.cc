#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "tests/twin/render/ranging_for_tests.h"
#include "twin/render/ranging/fan.h"
#include "twin/render/ranging/imaging_sonar.h"
#include "twin/render/ranging/lidar.h"

namespace slackwater::twin::ranging_test {
namespace {

constexpr double far_m = 60;

const Pose& ahead() {
  static const Pose pose = looking({0, 0, 0}, {1, 0, 0});
  return pose;
}

ImagingSonarSheet small_sonar() {
  ImagingSonarSheet sheet;
  sheet.beams = 41;
  sheet.across_rad = 40 * constants::degree;
  sheet.beam_rad = sheet.across_rad / 40;  // beams that leave no gaps
  sheet.upright_rad = 12 * constants::degree;
  sheet.rays = 600;
  sheet.bins = 600;
  sheet.absorption_db_m = 0.2;
  return sheet;
}

double sum_of(const std::vector<float>& values) {
  double sum = 0;
  for (const float value : values) sum += static_cast<double>(value);
  return sum;
}

// The middle beam at a wall met squarely: mu w / R^2 of the integral of cos^4 e b^2(e) and what the
// water takes.
TEST(ImagingSonar, EchoOfAWallIsItsClosedForm) {
  const Cast cast(wall_mesh(20));
  const ImagingSonarSheet sheet = small_sonar();
  const SonarImage image = pinged(cast.scene, cast.caster, sheet, ahead(), 0.1, far_m, 1, 1);
  double expected = 0;
  constexpr int steps = 20000;
  const double wide = 3 * sheet.upright_rad;
  for (int i = 0; i < steps; ++i) {
    const double e = ((i + 0.5) / steps - 0.5) * wide;
    const double pattern = std::exp(-std::log(2.0) * std::pow(2 * e / sheet.upright_rad, 2));
    expected += std::pow(std::cos(e), 4) * pattern * pattern *
                std::pow(10.0, -2 * 0.2 * (20 / std::cos(e)) / 10) * wide / steps;
  }
  expected *= std::pow(10.0, -2.7) * sheet.beam_rad / (20.0 * 20);
  double sum = 0;
  int first = -1;
  for (int bin = 0; bin < sheet.bins; ++bin) {
    const double value = image.mean[static_cast<std::size_t>(20 * sheet.bins + bin)];
    sum += value;
    if (first < 0 && value > 0) first = bin;
  }
  EXPECT_NEAR(sum / expected, 1, 1e-4);
  EXPECT_EQ(first, static_cast<int>(20 / far_m * sheet.bins)) << "the range of the wall";
}

// A sphere: mu times the integral of cos^2 i / r^4 over what is seen of it; of a small one far off
// Lambert's cross section, mu 2 pi a^2/3, over r^4.
TEST(ImagingSonar, EchoOfASphereIsLamberts) {
  constexpr double away_m = 30, radius_m = 0.8;
  const Cast cast(sphere_mesh(away_m, radius_m, 150));
  ImagingSonarSheet sheet = small_sonar();
  sheet.beams = 401;
  sheet.across_rad = 4 * constants::degree;
  sheet.beam_rad = sheet.across_rad / 400;
  sheet.upright_rad = 60 * constants::degree;
  sheet.rays = 12000;
  sheet.absorption_db_m = 0;
  const SonarImage image = pinged(cast.scene, cast.caster, sheet, ahead(), 0.1, far_m, 1, 2);
  double expected = 0;
  constexpr int steps = 20000;
  for (int i = 0; i < steps; ++i) {
    const double polar = (i + 0.5) * constants::pi / 2 / steps;
    const double r =
        std::sqrt(away_m * away_m + radius_m * radius_m - 2 * away_m * radius_m * std::cos(polar));
    const double cosine = (away_m * std::cos(polar) - radius_m) / r;
    if (cosine > 0)
      expected += cosine * cosine / std::pow(r, 4) * std::sin(polar) * constants::pi / 2 / steps;
  }
  expected *= std::pow(10.0, -2.7) * 2 * constants::pi * radius_m * radius_m;
  const double small = std::pow(10.0, -2.7) * 2 * constants::pi * radius_m * radius_m / 3;
  EXPECT_NEAR(expected / (small / std::pow(away_m, 4)), 1, 0.1);
  // The pattern takes 0.2 % towards the sphere's upper and lower edge.
  EXPECT_NEAR(sum_of(image.mean) / expected, 1, 4e-3);
}

TEST(ImagingSonar, LeftIsLeft) {
  Cast cast(sphere_mesh(20, 2, 40));
  // To starboard of a sonar that looks north is east.
  cast.scene.things[0].mesh.origin_m = {18, 6, 0};
  const RayCaster caster(std::vector<TriangleMesh>{cast.scene.things[0].mesh});
  const ImagingSonarSheet sheet = small_sonar();
  const SonarImage image = pinged(cast.scene, caster, sheet, ahead(), 0.1, far_m, 1, 1);
  const auto side = [&](int from, int to) {
    double sum = 0;
    for (int beam = from; beam < to; ++beam)
      for (int bin = 0; bin < sheet.bins; ++bin)
        sum += image.mean[static_cast<std::size_t>(beam * sheet.bins + bin)];
    return sum;
  };
  EXPECT_EQ(side(0, 20), 0);
  EXPECT_GT(side(21, 41), 0);
  EXPECT_GT(beam_bearing_rad(sheet.across_rad, sheet.beams, 40), 0);
}

// Rayleigh's speckle: the intensity has its mean and as much deviation.
TEST(ImagingSonar, SpeckleIsExponential) {
  const Cast cast(wall_mesh(20));
  ImagingSonarSheet sheet = small_sonar();
  sheet.beams = 301;
  sheet.bins = 2;
  sheet.noise_floor = 0;
  double sum = 0, squares = 0, count = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const SonarImage image = pinged(cast.scene, cast.caster, sheet, ahead(), 0.1, far_m, seed, 2);
    for (std::size_t i = 0; i < image.mean.size(); ++i) {
      if (!(image.mean[i] > 0)) continue;
      const double share = static_cast<double>(image.intensity[i]) / image.mean[i];
      sum += share;
      squares += share * share;
      ++count;
    }
  }
  EXPECT_GT(count, 2000);
  EXPECT_NEAR(sum / count, 1, 4 / std::sqrt(count));
  EXPECT_NEAR(squares / count - sum / count * sum / count, 1, 0.2);
}

TEST(ImagingSonar, IsTheSameOnAnyNumberOfThreadsAndInstructionSet) {
  const Cast cast(sphere_mesh(20, 3, 40));
  const ImagingSonarSheet sheet = small_sonar();
  const SonarImage one = pinged(cast.scene, cast.caster, sheet, ahead(), 0.1, far_m, 1, 1);
  const RayCaster narrow(std::vector<TriangleMesh>{cast.scene.things[0].mesh}, "isa=sse2");
  const SonarImage three = pinged(cast.scene, narrow, sheet, ahead(), 0.1, far_m, 1, 3);
  EXPECT_EQ(one.intensity, three.intensity);
}

LidarSheet small_lidar() {
  LidarSheet sheet;
  sheet.channels = 16;
  sheet.columns = 360;
  sheet.dropout = 0;
  return sheet;
}

TEST(Lidar, RangesOfAWallAreItsPlane) {
  const Cast cast(wall_mesh(20));
  const LidarSheet sheet = small_lidar();
  const LidarScan scan = scanned(cast.scene, cast.caster, sheet, ahead(), 0.5, far_m, 0, 3, 2);
  double squares = 0, count = 0;
  for (int channel = 0; channel < 16; ++channel)
    for (int column = 0; column < 360; ++column) {
      const auto at = static_cast<std::size_t>(channel * 360 + column);
      const double ahead_share = lidar_direction(sheet, ahead(), channel, column).x;
      if (!(ahead_share > 20 / far_m + 1e-3)) continue;
      ASSERT_NEAR(scan.true_range_m[at], 20 / ahead_share, 1e-4);
      EXPECT_EQ(scan.instance[at], 1);
      // Albedo 0.1 of this material: headroom 5 is 0.5 squarely at the longest range.
      const double told = 0.5 * ahead_share * std::pow(far_m / (20 / ahead_share), 2);
      EXPECT_NEAR(scan.intensity[at], told, 1e-4 * told);
      EXPECT_EQ(std::isnan(scan.range_m[at]), told < 1) << told;
      if (!(told > 1)) continue;
      squares += std::pow((scan.range_m[at] - 20 / ahead_share) / sheet.noise_sd_m, 2);
      ++count;
    }
  EXPECT_GT(count, 500);
  EXPECT_NEAR(squares / count, 1, 0.2);
}

TEST(Lidar, RangesOfASphereAndItsBearings) {
  const Cast cast(sphere_mesh(10, 2, 100));
  const LidarSheet sheet = small_lidar();
  const LidarScan scan = scanned(cast.scene, cast.caster, sheet, ahead(), 0.5, far_m, 0, 3, 1);
  for (int channel = 0; channel < 16; ++channel)
    for (int column = 0; column < 360; ++column) {
      const double cosine = lidar_direction(sheet, ahead(), channel, column).x;
      const double beside2 = 100 * (1 - cosine * cosine);
      const auto at = static_cast<std::size_t>(channel * 360 + column);
      if (cosine <= 0 || beside2 > 4.01) {
        EXPECT_EQ(scan.instance[at], 0);
      }
      if (cosine <= 0 || beside2 > 3.9) continue;
      EXPECT_NEAR(scan.true_range_m[at], 10 * cosine - std::sqrt(4 - beside2), 5e-3);
    }
}

// Of pulses at a wall r off 1 - exp(-k r) meet a drop first; some of them are told, at ranges whose
// share below x is 1 - exp(-k x). The truth does not change.
TEST(Lidar, DropsInTheAirTakeAsManyAsStated) {
  const Cast cast(wall_mesh(20));
  LidarSheet sheet = small_lidar();
  sheet.noise_sd_m = 0;
  sheet.headroom = 100;
  const LidarScan clear = scanned(cast.scene, cast.caster, sheet, ahead(), 0.01, far_m, 0, 3, 1);
  sheet.drops_per_m = 0.02;
  sheet.drops_told = 0.3;
  double pulses = 0, told_of_drop = 0, nothing = 0, expected = 0, near = 0, expected_near = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const LidarScan wet = scanned(cast.scene, cast.caster, sheet, ahead(), 0.01, far_m, 0, seed, 2);
    for (std::size_t i = 0; i < clear.range_m.size(); ++i) {
      if (std::isnan(clear.true_range_m[i])) continue;
      ASSERT_EQ(wet.true_range_m[i], clear.true_range_m[i]);
      EXPECT_EQ(wet.instance[i], 1);
      const double r = static_cast<double>(clear.true_range_m[i]);
      ++pulses;
      expected += 1 - std::exp(-0.02 * r);
      expected_near += 0.3 * (1 - std::exp(-0.02 * 10));
      if (std::isnan(wet.range_m[i])) {
        ++nothing;
      } else if (static_cast<double>(wet.range_m[i]) < r - 0.002) {
        ++told_of_drop;
        near += wet.range_m[i] < 10 ? 1 : 0;
      }
    }
  }
  const double sd = std::sqrt(expected);
  EXPECT_GT(pulses, 20000);
  EXPECT_NEAR(nothing + told_of_drop, expected, 4 * sd);
  EXPECT_NEAR(told_of_drop, 0.3 * expected, 4 * std::sqrt(0.3) * sd);
  EXPECT_NEAR(near, expected_near, 4 * std::sqrt(expected_near));
}

TEST(Lidar, FogTakesItsLightTwiceAndDropOutsAreAsManyAsStated) {
  const Cast cast(wall_mesh(10));
  LidarSheet sheet = small_lidar();
  sheet.dropout = 0.1;
  const LidarScan clear = scanned(cast.scene, cast.caster, sheet, ahead(), 0.5, far_m, 0, 3, 1);
  const LidarScan fog = scanned(cast.scene, cast.caster, sheet, ahead(), 0.5, far_m, 0.1, 3, 1);
  const std::size_t at = 8 * 360;
  EXPECT_NEAR(fog.intensity[at] / clear.intensity[at], std::exp(-0.2 * clear.true_range_m[at]),
              1e-5);
  double lost = 0, strong = 0;
  for (std::size_t i = 0; i < clear.range_m.size(); ++i) {
    if (!(clear.intensity[i] > 1)) continue;
    ++strong;
    lost += std::isnan(clear.range_m[i]) ? 1 : 0;
  }
  EXPECT_NEAR(lost / strong, 0.1, 0.03);
}

}  // namespace
}  // namespace slackwater::twin::ranging_test
