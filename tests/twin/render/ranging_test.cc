#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "tests/twin/inspection/meshes_for_tests.h"
#include "tests/twin/render/render_for_tests.h"
#include "twin/render/ranging/imaging_sonar.h"
#include "twin/render/ranging/lidar.h"

namespace slackwater::twin::ranging_test {
namespace {

constexpr double far_m = 60;

struct Cast {
  RenderScene scene;
  RayCaster caster;

  explicit Cast(TriangleMesh mesh)
      : scene(of(std::move(mesh))), caster(std::vector<TriangleMesh>{scene.things[0].mesh}) {}
  static RenderScene of(TriangleMesh mesh) {
    RenderScene scene;
    scene.things.push_back({"thing", SeenClass::structure, Material::none, std::move(mesh)});
    return scene;
  }
};

/// An upright wall, facing south, `ahead_m` north.
TriangleMesh wall_mesh(double ahead_m) {
  return {{ahead_m, 0, 0},
          {{0, -200, -200}, {0, 200, -200}, {0, 200, 200}, {0, -200, 200}},
          {{0, 2, 1}, {0, 3, 2}}};
}

/// A sphere north of the origin.
TriangleMesh sphere_mesh(double ahead_m, double radius_m, std::uint32_t rings) {
  TriangleMesh mesh;
  mesh.origin_m = {ahead_m, 0, 0};
  const std::uint32_t round = 2 * rings;
  for (std::uint32_t k = 0; k <= rings; ++k)
    for (std::uint32_t i = 0; i < round; ++i) {
      const double up = constants::pi * k / rings, turn = 2 * constants::pi * i / round;
      mesh.corners.push_back({static_cast<float>(radius_m * std::sin(up) * std::cos(turn)),
                              static_cast<float>(radius_m * std::sin(up) * std::sin(turn)),
                              static_cast<float>(-radius_m * std::cos(up))});
    }
  for (std::uint32_t k = 0; k < rings; ++k)
    for (std::uint32_t i = 0; i < round; ++i) {
      const std::uint32_t a = k * round + i, b = k * round + (i + 1) % round;
      mesh.triangles.push_back({a, b, b + round});
      mesh.triangles.push_back({a, b + round, a + round});
    }
  return mesh;
}

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
  EXPECT_GT(sonar_bearing_rad(sheet, 40), 0);
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

TEST(Multibeam, DepthOfALevelBedIsWithinItsStatedNoise) {
  const Cast cast(level_mesh({-100, -100, 15}, 10, 20, 20));
  // Looks down, the beams across: east to the right of a bow to the north.
  Pose pose = looking({0, 0, 0}, {0, 0, 1});
  pose.right = {0, 1, 0};
  const auto soundings = sounded(cast.caster, pose, 512, 2.0, 0.02, 0.001, 0.5, far_m, 9);
  ImagingSonarSheet fan;
  fan.beams = 512;
  fan.across_rad = 2.0;
  double squares = 0;
  for (int beam = 0; beam < 512; ++beam) {
    const Sounding& one = soundings[static_cast<std::size_t>(beam)];
    const double range_m = 15 / std::cos(sonar_bearing_rad(fan, beam));
    EXPECT_NEAR(one.true_range_m, range_m, 1e-4);
    const double sd_m = 0.02 + 0.001 * range_m;
    EXPECT_LT(std::abs(one.range_m - range_m), 5 * sd_m);
    squares += std::pow((one.range_m - range_m) / sd_m, 2) / 512;
  }
  EXPECT_NEAR(squares, 1, 0.25);
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
