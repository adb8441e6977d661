#include "twin/render/frame/frame_hits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fields/base/numbers/random.h"
#include "tests/twin/inspection/brute_force_caster.h"
#include "tests/twin/inspection/meshes_for_tests.h"
#include "tests/twin/render/render_for_tests.h"
#include "twin/inspection/cast/ray_caster.h"

namespace slackwater::twin::frame_hits_test {
namespace {

constexpr double most_range_m = 300;

/// A pile, a bed below it, a smaller pile, each about its own origin, and plates that lie across
/// the eye's plane; with triangles that lie twice, or have shrunk to a line.
std::vector<TriangleMesh> made_up_scene() {
  std::vector<TriangleMesh> meshes{
      cylinder_mesh({100, -40, -8}, 4, 38, 24, 12), level_mesh({70, -70, 30}, 10, 6, 6),
      cylinder_mesh({131.7, -22.3, 3}, 1, 27, 12, 5), level_mesh({-900, -900, 60}, 600, 3, 3)};
  meshes[0].triangles.push_back(meshes[0].triangles[7]);
  meshes[1].triangles.push_back({0, 1, 2});
  meshes[1].triangles.push_back({3, 3, 3});
  return meshes;
}

FrameHits seen(const Pinhole& camera, const std::vector<TriangleMesh>& meshes, int threads) {
  std::vector<const TriangleMesh*> given;
  for (const TriangleMesh& mesh : meshes) given.push_back(&mesh);
  FrameHits hits;
  find_first_hits(camera, given, most_range_m, threads, hits);
  return hits;
}

/// The frame that rays one by one make.
template <typename Cast>
FrameHits by_rays(const Pinhole& camera, const Cast& cast) {
  FrameHits hits;
  hits.wide = camera.wide();
  hits.high = camera.high();
  for (int j = 0; j < camera.high(); ++j)
    for (int i = 0; i < camera.wide(); ++i) {
      const std::optional<CastHit> hit = cast(camera.ray(i, j));
      hits.range_m.push_back(hit ? hit->range_m : std::numeric_limits<double>::infinity());
      hits.mesh.push_back(hit ? hit->mesh : FrameHits::nothing);
      hits.triangle.push_back(hit ? hit->triangle : FrameHits::nothing);
    }
  return hits;
}

/// Eyes about the scene: in general places, within the pile, with a corner of a triangle, an edge
/// or a triangle's plane through the eye, and all but in the plane of the bed.
std::vector<Pose> eyes_about(const std::vector<TriangleMesh>& meshes) {
  Rng rng(5, "test/render");
  std::vector<Pose> poses;
  for (int i = 0; i < 12; ++i)
    poses.push_back(looking({rng.uniform(60, 150), rng.uniform(-80, 0), rng.uniform(-20, 28)},
                            {100, -40, rng.uniform(0, 25)}));
  poses.push_back(looking({100.5, -40.2, 10}, {104, -41, 11}));
  poses.push_back(looking({100, -40, 12}, {100.01, -40, 30}));
  poses.push_back(looking(meshes[0].corner_m(30), {100, -40, 9}));
  poses.push_back(looking(meshes[1].corner_m(8), {100, -40, 9}));
  poses.push_back(looking(0.5 * (meshes[0].corner_m(30) + meshes[0].corner_m(31)), {101, -39, 5}));
  poses.push_back(looking({60, -90, 30}, {100, -40, 30}));
  poses.push_back(looking({60, -90, 30 - 1e-7}, {100, -40, 30}));
  poses.push_back(looking({95, -45, 30.0005}, {100, -40, 30}));
  poses.push_back(looking({95, -45, 29.9995}, {95.00001, -45, 40}));
  return poses;
}

TEST(FrameHits, AreThoseOfAllTrianglesOneByOne) {
  const auto meshes = made_up_scene();
  std::size_t met = 0, frames = 0;
  for (const Pose& pose : eyes_about(meshes))
    for (const double wide_deg : {3.0, 64.0, 120.0}) {
      const Pinhole camera(pose, frame_of(28, 21, wide_deg));
      const FrameHits hits = seen(camera, meshes, 1);
      const FrameHits expected = by_rays(
          camera, [&](const Ray& ray) { return by_brute_force(meshes, ray, most_range_m); });
      EXPECT_EQ(hits, expected) << "frame " << frames;
      for (std::size_t i = 0; i < hits.pixels(); ++i) met += hits.is_hit(i) ? 1 : 0;
      ++frames;
    }
  EXPECT_GT(met, frames * 200);
}

TEST(FrameHits, AreThoseOfRaysOnEachInstructionSetAndThreadCount) {
  std::vector<TriangleMesh> meshes{cylinder_mesh({0, 0, -10}, 4, 50, 88, 70),
                                   level_mesh({-12, -12, 40}, 1, 24, 24)};
  const Pinhole camera(looking({14, 3, 22}, {0, 0, 30}), frame_of(160, 120, 70));
  const FrameHits hits = seen(camera, meshes, 1);
  std::vector<const char*> sets{"isa=sse2"};
  if (__builtin_cpu_supports("avx2")) sets.push_back("isa=avx2");
  if (__builtin_cpu_supports("avx512dq")) sets.push_back("isa=avx512");
  for (const char* isa : sets) {
    const RayCaster caster(meshes, isa);
    EXPECT_EQ(hits,
              by_rays(camera, [&](const Ray& ray) { return caster.first_hit(ray, most_range_m); }))
        << isa;
  }
  EXPECT_EQ(hits, seen(camera, meshes, 2));
  EXPECT_EQ(hits, seen(camera, meshes, 5));
}

TEST(FrameHits, EndAtTheirLongestRange) {
  const std::vector<TriangleMesh> meshes{level_mesh({-50, -50, 10}, 10, 10, 10)};
  const Pinhole camera(looking({0, 0, 0}, {1e-9, 0, 10}), frame_of(64, 64, 90));
  std::vector<const TriangleMesh*> given{&meshes[0]};
  FrameHits hits;
  find_first_hits(camera, given, 12, 1, hits);
  for (int j = 0; j < 64; ++j)
    for (int i = 0; i < 64; ++i) {
      const double range_m = 10 / camera.ray(i, j).direction.z;
      const auto at = static_cast<std::size_t>(j * 64 + i);
      EXPECT_EQ(hits.is_hit(at), range_m <= 12);
      if (hits.is_hit(at)) {
        EXPECT_NEAR(hits.range_m[at], range_m, 1e-12);
      }
    }
}

TEST(FrameHits, ASeenPlaceProjectsIntoItsPixel) {
  const auto meshes = made_up_scene();
  const Pinhole camera(looking({85, -60, 5}, {100, -40, 9}), frame_of(80, 60, 50));
  const FrameHits hits = seen(camera, meshes, 1);
  for (int j = 0; j < 60; ++j)
    for (int i = 0; i < 80; ++i) {
      const auto at = static_cast<std::size_t>(j * 80 + i);
      if (!hits.is_hit(at)) continue;
      const Ray ray = camera.ray(i, j);
      const auto place = camera.place_of(ray.from_m + hits.range_m[at] * ray.direction);
      ASSERT_TRUE(place);
      EXPECT_NEAR(place->u, i + 0.5, 1e-9);
      EXPECT_NEAR(place->v, j + 0.5, 1e-9);
    }
}

}  // namespace
}  // namespace slackwater::twin::frame_hits_test
