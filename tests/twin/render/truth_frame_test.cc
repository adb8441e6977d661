#include "twin/render/frame/truth_frame.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "tests/twin/inspection/meshes_for_tests.h"
#include "tests/twin/render/render_for_tests.h"

namespace slackwater::twin::truth_frame_test {
namespace {

constexpr double far_m = 1000;
constexpr double of_a_float = 1e-6;

RenderScene of(TriangleMesh mesh) {
  RenderScene scene;
  scene.things.push_back({"thing", SeenClass::structure, Material::none, std::move(mesh)});
  return scene;
}

TruthFrame truth(const RenderScene& scene, const Pinhole& camera,
                 const OtherMoment* other = nullptr, int threads = 1) {
  FrameHits hits;
  return truth_of(scene, camera, far_m, threads, hits, other);
}

std::size_t pixel(const Pinhole& camera, int i, int j) {
  return static_cast<std::size_t>(j * camera.wide() + i);
}

/// A sphere of so many rings of triangles.
TriangleMesh sphere_mesh(const Triple<double>& centre_m, double radius_m, std::uint32_t rings) {
  TriangleMesh mesh;
  mesh.origin_m = centre_m;
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

TEST(TruthFrame, OfALevelPlaneHasTheDepthOfThePlane) {
  const RenderScene scene = of(level_mesh({-50, -50, 12}, 5, 20, 20));
  const Pinhole down(looking({0.3, 0.2, 0}, {0.3, 0.2, 12}), frame_of(40, 30, 60));
  const TruthFrame frame = truth(scene, down);
  for (int j = 0; j < 30; ++j)
    for (int i = 0; i < 40; ++i) {
      const std::size_t at = pixel(down, i, j);
      EXPECT_NEAR(frame.depth_m[at], 12, 12 * of_a_float);
      EXPECT_NEAR(frame.range_m[at], 12 / down.ray(i, j).direction.z, 20 * of_a_float);
      EXPECT_NEAR(frame.normal[at][2], -1, of_a_float);
      EXPECT_EQ(frame.instance[at], 1);
      EXPECT_EQ(frame.seen_class[at], SeenClass::structure);
      EXPECT_EQ(frame.defect[at], 0);
    }
}

// A plate tilted by t about the picture's right: depth along the row v is z / (1 - (v/f) tan t).
TEST(TruthFrame, OfATiltedPlateHasItsDepthAndNormal) {
  const double tilt = 25 * constants::degree;
  TriangleMesh mesh;
  mesh.origin_m = {6, 0, 0};
  const auto c = static_cast<float>(std::cos(tilt)), s = static_cast<float>(std::sin(tilt));
  mesh.corners = {{-9 * s, -9, -9 * c}, {-9 * s, 9, -9 * c}, {9 * s, 9, 9 * c}, {9 * s, -9, 9 * c}};
  mesh.triangles = {{0, 2, 1}, {0, 3, 2}};
  const RenderScene scene = of(mesh);
  const Pinhole camera(looking({0, 0, 0}, {1, 0, 0}), frame_of(32, 24, 50));
  const TruthFrame frame = truth(scene, camera);
  for (int j = 0; j < 24; ++j)
    for (int i = 0; i < 32; ++i) {
      const double v = (j + 0.5 - 12) / camera.focal_v();
      const std::size_t at = pixel(camera, i, j);
      EXPECT_NEAR(frame.depth_m[at], 6 / (1 - v * std::tan(tilt)), 1e-5);
      EXPECT_NEAR(frame.normal[at][1], std::sin(tilt), of_a_float);
      EXPECT_NEAR(frame.normal[at][2], -std::cos(tilt), of_a_float);
    }
}

TEST(TruthFrame, OfASphereHasItsRangeAndOutline) {
  constexpr double away_m = 5, radius_m = 1;
  const RenderScene scene = of(sphere_mesh({away_m, 0, 0}, radius_m, 200));
  const Pinhole camera(looking({0, 0, 0}, {1, 0, 0}), frame_of(120, 90, 40));
  const TruthFrame frame = truth(scene, camera);
  std::size_t seen = 0;
  for (int j = 0; j < 90; ++j)
    for (int i = 0; i < 120; ++i) {
      const double cosine = camera.ray(i, j).direction.x;
      const double beside2 = away_m * away_m * (1 - cosine * cosine);
      const std::size_t at = pixel(camera, i, j);
      // A facet's diagonal lies within a pi^2/(2 200^2)/2 of the sphere, 6e-5 m.
      if (beside2 > radius_m * radius_m + 1e-3) {
        EXPECT_EQ(frame.instance[at], 0);
      }
      if (beside2 > radius_m * radius_m - 1e-2) continue;
      ++seen;
      ASSERT_EQ(frame.instance[at], 1);
      const double range_m = away_m * cosine - std::sqrt(radius_m * radius_m - beside2);
      const double aslant = std::sqrt(1 - beside2);
      EXPECT_NEAR(frame.range_m[at], range_m, 7e-5 / aslant);
    }
  // tan of the outline's angle, asin(a/d): f^2 pi tan^2 pixels.
  const double f = camera.focal_u();
  EXPECT_NEAR(static_cast<double>(seen), constants::pi * f * f / (away_m * away_m - 1), 80);
}

/// A mark on the wall x = ahead, seen from the south.
DefectMark mark_on_wall(DefectKind kind, double ahead_m, double y_m, double z_m, double half_m,
                        double half_down_m, double turn_rad) {
  DefectMark mark;
  mark.kind = kind;
  mark.centre_m = {ahead_m, y_m, z_m};
  mark.normal = {-1, 0, 0};
  mark.along = {0, std::cos(turn_rad), std::sin(turn_rad)};
  mark.down = cross(mark.normal, mark.along);
  mark.half_along_m = half_m;
  mark.half_down_m = half_down_m;
  return mark;
}

// The mask of a defect is its outline, projected: what lies within the projected ellipse, to the
// pixel.
TEST(TruthFrame, MasksADefectToThePixel) {
  RenderScene scene = of(TriangleMesh{
      {4, 0, 0}, {{0, -9, -9}, {0, 9, -9}, {0, 9, 9}, {0, -9, 9}}, {{0, 2, 1}, {0, 3, 2}}});
  const double turn = 0.6;
  scene.marks = {mark_on_wall(DefectKind::corrosion, 4, 0.5, -0.2, 0.8, 0.35, turn),
                 mark_on_wall(DefectKind::crack, 4, -0.9, 0.3, 0.5, 0.04, -0.4)};
  const Pinhole camera(looking({0, 0.4, 0.1}, {4, 0, 0}), frame_of(200, 150, 50));
  const TruthFrame frame = truth(scene, camera);
  std::array<std::size_t, 3> counted{};
  for (int j = 0; j < 150; ++j)
    for (int i = 0; i < 200; ++i) {
      // By hand: where the ray meets the wall.
      const Ray ray = camera.ray(i, j);
      const double range_m = 4 / ray.direction.x;
      const double y = ray.from_m.y + range_m * ray.direction.y;
      const double z = ray.from_m.z + range_m * ray.direction.z;
      const double a = (y - 0.5) * std::cos(turn) + (z + 0.2) * std::sin(turn);
      const double d = -(y - 0.5) * std::sin(turn) + (z + 0.2) * std::cos(turn);
      const double a2 = (y + 0.9) * std::cos(-0.4) + (z - 0.3) * std::sin(-0.4);
      const double d2 = -(y + 0.9) * std::sin(-0.4) + (z - 0.3) * std::cos(-0.4);
      std::uint16_t expected = 0;
      if (a * a / 0.64 + d * d / (0.35 * 0.35) <= 1) expected = 1;
      if (std::abs(a2) <= 0.5 && std::abs(d2) <= 0.04) expected = 2;
      ++counted[expected];
      EXPECT_EQ(frame.defect[pixel(camera, i, j)], expected) << i << ' ' << j;
    }
  // And its size in pixels: pi a b f^2 / z^2 of the ellipse, within its edge.
  const double per_m2 = camera.focal_u() * camera.focal_u() / 16;
  EXPECT_NEAR(static_cast<double>(counted[1]), constants::pi * 0.8 * 0.35 * per_m2,
              0.1 * constants::pi * 0.8 * 0.35 * per_m2);
  EXPECT_GT(counted[2], 20U);
}

// A camera that goes sideways by s: flow -f s / depth; one that turns: none of depth.
TEST(TruthFrame, FlowIsThatOfTheCamera) {
  const RenderScene scene = of(level_mesh({-50, -50, 8}, 5, 20, 20));
  const Pinhole now(looking({0, 0, 0}, {0, 0, 8}), frame_of(32, 24, 60));
  const Pinhole aside(looking({0.1, -0.2, 0}, {0.1, -0.2, 8}), frame_of(32, 24, 60));
  const OtherMoment then{scene, aside};
  const TruthFrame frame = truth(scene, now, &then);
  for (std::size_t at = 0; at < frame.pixels(); ++at) {
    EXPECT_NEAR(frame.flow[at][0], -now.focal_u() * 0.1 / 8, 1e-5);  // right is north
    EXPECT_NEAR(frame.flow[at][1], now.focal_v() * 0.2 / 8, 1e-5);   // down is east
  }
}

// What moves before a camera at rest: a plate that comes nearer grows about the middle, one that
// turns about the axis turns.
TEST(TruthFrame, FlowIsThatOfTheThing) {
  const auto plate = [](double ahead_m, double turn) {
    TriangleMesh mesh;
    mesh.origin_m = {ahead_m, 0, 0};
    for (const auto& [y, z] : {std::pair{-9.0, -9.0}, {9.0, -9.0}, {9.0, 9.0}, {-9.0, 9.0}})
      mesh.corners.push_back({0, static_cast<float>(y * std::cos(turn) - z * std::sin(turn)),
                              static_cast<float>(y * std::sin(turn) + z * std::cos(turn))});
    mesh.triangles = {{0, 2, 1}, {0, 3, 2}};
    return of(mesh);
  };
  const Pinhole camera(looking({0, 0, 0}, {1, 0, 0}), frame_of(32, 24, 60));
  const RenderScene now = plate(6, 0), nearer = plate(5, 0.1);
  const OtherMoment then{nearer, camera};
  const TruthFrame frame = truth(now, camera, &then);
  for (int j = 0; j < 24; ++j)
    for (int i = 0; i < 32; ++i) {
      const double u = i + 0.5 - 16, v = j + 0.5 - 12;
      const double u2 = 6.0 / 5 * (u * std::cos(0.1) - v * std::sin(0.1));
      const double v2 = 6.0 / 5 * (u * std::sin(0.1) + v * std::cos(0.1));
      EXPECT_NEAR(frame.flow[pixel(camera, i, j)][0], u2 - u, 2e-5);
      EXPECT_NEAR(frame.flow[pixel(camera, i, j)][1], v2 - v, 2e-5);
    }
}

TEST(TruthFrame, IsTheSameOnAnyNumberOfThreads) {
  RenderScene scene = of(cylinder_mesh({5, 0, -10}, 3, 40, 48, 20));
  scene.marks = {mark_on_wall(DefectKind::corrosion, 2, 0, 0, 0.8, 0.35, 0.2)};
  const Pinhole camera(looking({0, 0, 0}, {5, 0.3, 0.2}), frame_of(64, 48, 64));
  const OtherMoment then{scene, camera};
  const TruthFrame one = truth(scene, camera, &then, 1), three = truth(scene, camera, &then, 3);
  EXPECT_EQ(one.instance, three.instance);
  EXPECT_EQ(one.defect, three.defect);
  EXPECT_EQ(one.normal, three.normal);
  for (std::size_t at = 0; at < one.pixels(); ++at) {
    if (one.instance[at] == 0) continue;
    EXPECT_EQ(one.depth_m[at], three.depth_m[at]);
    EXPECT_NEAR(one.flow[at][0], 0, 1e-4) << "nothing moved";
  }
}

}  // namespace
}  // namespace slackwater::twin::truth_frame_test
