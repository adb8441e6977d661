#include "twin/inspection/cast/ray_caster.h"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <tuple>
#include <vector>

#include "fields/base/check.h"
#include "fields/base/numbers/random.h"
#include "fields/base/parallel.h"
#include "tests/bench/counted_allocations.h"
#include "tests/twin/inspection/brute_force_caster.h"
#include "tests/twin/inspection/meshes_for_tests.h"

namespace slackwater::twin::ray_caster_test {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

/// A pile, a bed below it and a smaller pile a stone's throw away, each about its own origin; with
/// triangles that lie twice, or have shrunk to a line.
std::vector<TriangleMesh> made_up_scene() {
  std::vector<TriangleMesh> meshes{cylinder_mesh({100, -40, -8}, 4, 38, 24, 6),
                                   level_mesh({70, -70, 30}, 10, 6, 6),
                                   cylinder_mesh({131.7, -22.3, 3}, 1, 27, 12, 5)};
  meshes[0].triangles.push_back(meshes[0].triangles[7]);
  meshes[1].triangles.push_back({0, 1, 2});
  meshes[1].triangles.push_back({3, 3, 3});
  return meshes;
}

Triple<double> random_unit(Rng& rng) { return unit({rng.normal(), rng.normal(), rng.normal()}); }

/// Rays from about the scene, from inside of the piles and from far off; at nothing in particular,
/// at the inside of a triangle, at an edge, at a corner; along axes, within planes of the scene.
std::vector<Ray> rays_at(const std::vector<TriangleMesh>& meshes, std::size_t count) {
  Rng rng(17, "test/cast");
  std::vector<Ray> rays;
  while (rays.size() < count) {
    const TriangleMesh& mesh = meshes[rng.bits() % meshes.size()];
    const auto& triangle = mesh.triangles[rng.bits() % mesh.triangles.size()];
    const auto corner = [&](std::size_t i) -> Triple<double> {
      const auto& c = mesh.corners[triangle[i]];
      return mesh.origin_m + Triple<double>{c[0], c[1], c[2]};
    };
    Triple<double> from{rng.uniform(60, 150), rng.uniform(-80, 0), rng.uniform(-20, 40)};
    const std::uint64_t start = rng.bits() % 8;
    if (start == 0) from = 1000.0 * from;
    if (start == 1) from = mesh.origin_m + Triple<double>{0.1, 0.2, 5};
    if (start == 2) from = corner(0);
    const double u = rng.uniform(), v = rng.uniform(0, 1 - u);
    Triple<double> at = corner(0);
    switch (rng.bits() % 5) {
      case 0:
        at = from + random_unit(rng);
        break;
      case 1:
        at = corner(0) + u * (corner(1) - corner(0)) + v * (corner(2) - corner(0));
        break;
      case 2:
        at = corner(0) + u * (corner(1) - corner(0));
        break;
      case 3:
        at = corner(1);
        break;
      default:
        const std::uint64_t axis = rng.bits() % 3;
        at = from +
             Triple<double>{axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
    }
    if (length_of(at - from) > 0) rays.push_back({from, unit(at - from)});
  }
  return rays;
}

TEST(RayCaster, IsTheBruteForceCasterToTheBit) {
  const auto meshes = made_up_scene();
  const RayCaster caster(meshes);
  std::size_t hits = 0;
  for (const Ray& ray : rays_at(meshes, 25000)) {
    const auto expected = by_brute_force(meshes, ray, endless);
    hits += expected ? 1 : 0;
    ASSERT_EQ(caster.first_hit(ray, endless), expected);
    ASSERT_EQ(caster.is_blocked(ray, endless), expected.has_value());
    if (!expected) continue;
    ASSERT_EQ(caster.first_hit(ray, expected->range_m), expected) << "ends on what it meets";
    const double less_m = std::nextafter(expected->range_m, -1.0);
    ASSERT_EQ(caster.first_hit(ray, less_m), std::nullopt);
    ASSERT_FALSE(caster.is_blocked(ray, less_m));
  }
  EXPECT_GT(hits, 10000U);
  EXPECT_LT(hits, 22500U);
}

TEST(RayCaster, GivesTheSameBitsOnEachInstructionSet) {
  const auto meshes = made_up_scene();
  const auto rays = rays_at(meshes, 100000);
  std::vector<std::string> sets{"isa=sse2"};
  if (__builtin_cpu_supports("sse4.2")) sets.emplace_back("isa=sse4.2");
  if (__builtin_cpu_supports("avx")) sets.emplace_back("isa=avx");
  if (__builtin_cpu_supports("avx2")) sets.emplace_back("isa=avx2");
  if (__builtin_cpu_supports("avx512dq")) sets.emplace_back("isa=avx512");
  if (sets.size() < 2) GTEST_SKIP() << "this machine has one instruction set";
  const RayCaster first(meshes, sets.front());
  std::vector<std::optional<CastHit>> expected(rays.size());
  first.first_hits(rays, 500, expected);
  for (const std::string& set : sets) {
    const RayCaster caster(meshes, set);
    std::vector<std::optional<CastHit>> hits(rays.size());
    caster.first_hits(rays, 500, hits);
    EXPECT_EQ(hits, expected) << set;
  }
}

TEST(RayCaster, ThreadsGetTheSameAnswers) {
  const auto meshes = made_up_scene();
  const RayCaster caster(meshes);
  const auto rays = rays_at(meshes, 20000);
  std::vector<std::optional<CastHit>> expected(rays.size());
  caster.first_hits(rays, endless, expected);
  std::atomic<std::size_t> unlike{0};
  for_all(8, 4, [&](std::size_t) {
    std::vector<std::optional<CastHit>> hits(rays.size());
    caster.first_hits(rays, endless, hits);
    if (hits != expected) ++unlike;
  });
  EXPECT_EQ(unlike, 0U);
}

// From within a closed body every ray meets it: also one straight at an edge or a corner.
TEST(RayCaster, LetsNoRayOutOfAClosedBody) {
  const std::vector<TriangleMesh> meshes{cylinder_mesh({0.3, 0.7, 0.1}, 4, 20, 37, 9),
                                         level_mesh({-10, -10, 20.1}, 2.5, 8, 8),
                                         level_mesh({-10, -10, 0.1}, 2.5, 8, 8)};
  const RayCaster caster(meshes);
  Rng rng(3, "test/closed");
  for (int i = 0; i < 50000; ++i) {
    const Triple<double> from{rng.uniform(-2, 2), rng.uniform(-2, 2), rng.uniform(1, 19)};
    const auto& at = meshes[0].corners[rng.bits() % meshes[0].corners.size()];
    const auto& next = meshes[0].corners[rng.bits() % meshes[0].corners.size()];
    const double share = i % 2 == 0 ? 0 : rng.uniform();
    const Triple<double> target =
        meshes[0].origin_m + Triple<double>{at[0] + share * (next[0] - at[0]),
                                            at[1] + share * (next[1] - at[1]),
                                            at[2] + share * (next[2] - at[2])};
    const auto hit = caster.first_hit({from, unit(target - from)}, 100);
    ASSERT_TRUE(hit.has_value());
    // Within the chord's sagitta of where it aims, on the curved face.
    if (i % 2 == 0) {
      ASSERT_NEAR(hit->range_m, length_of(target - from), 1e-9);
    }
  }
}

TEST(RayCaster, MeetsACylinderWhereGeometrySays) {
  const std::vector<TriangleMesh> meshes{cylinder_mesh({0, 0, 0}, 4, 20, 3600, 1)};
  const RayCaster caster(meshes);
  const auto hit = caster.first_hit({{-14, 1, 7}, {1, 0, 0}}, 100);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->range_m, 14 - std::sqrt(15.0), 2e-6) << "sagitta: R (1 - cos(pi/3600))";
  const auto from_inside = caster.first_hit({{0, 1, 7}, {1, 0, 0}}, 100);
  ASSERT_TRUE(from_inside);
  EXPECT_NEAR(from_inside->range_m, std::sqrt(15.0), 2e-6);
}

TEST(RayCaster, FindsNothingInAnEmptyScene) {
  const RayCaster none(std::vector<TriangleMesh>{});
  EXPECT_FALSE(none.first_hit({{0, 0, 0}, {1, 0, 0}}, endless));
  EXPECT_FALSE(none.is_blocked({{0, 0, 0}, {1, 0, 0}}, endless));
  std::vector<TriangleMesh> meshes(3);
  const RayCaster empty(meshes);
  EXPECT_FALSE(empty.first_hit({{0, 0, 0}, {1, 0, 0}}, endless));
  meshes[1] = level_mesh({0, 0, 5}, 1, 1, 1);
  const RayCaster one(meshes);
  const auto hit = one.first_hit({{0.5, 0.25, 0}, {0, 0, 1}}, endless);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->mesh, 1U) << "by its place among those that were given";
  EXPECT_EQ(hit->range_m, 5);
}

TEST(RayCaster, ARayWithoutDirectionMeetsNothing) {
  const std::vector<TriangleMesh> meshes{level_mesh({0, 0, 0}, 1, 4, 4)};
  const RayCaster caster(meshes);
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  for (const Triple<double>& direction :
       {Triple<double>{0, 0, 0}, Triple<double>{nothing, 0, 0}, Triple<double>{0, nothing, nothing},
        Triple<double>{0, 1, 0}}) {
    EXPECT_FALSE(caster.first_hit({{1.5, 1.5, 0}, direction}, endless));
    EXPECT_FALSE(caster.is_blocked({{1.5, 1.5, 0}, direction}, 10));
  }
  EXPECT_FALSE(caster.first_hit({{nothing, 1.5, -1}, {0, 0, 1}}, endless));
  EXPECT_FALSE(caster.first_hit({{endless, 1.5, -1}, {0, 0, 1}}, endless));
  EXPECT_FALSE(caster.first_hit({{1.5, 1.5, -1}, {0, 0, 1}}, nothing));
  EXPECT_FALSE(caster.first_hit({{1.5, 1.5, -1}, {0, 0, 1}}, -1));
  EXPECT_TRUE(caster.first_hit({{1.5, 1.5, -1}, {0, 0, 1}}, 1));
}

TEST(RayCaster, AFarOriginCostsNoTriangle) {
  std::vector<TriangleMesh> meshes{level_mesh({4e5, 6e6, 30}, 0.5, 20, 20)};
  const RayCaster caster(meshes);
  Rng rng(5, "test/far");
  for (int i = 0; i < 2000; ++i) {
    const Ray ray{{4e5 + rng.uniform(0, 10), 6e6 + rng.uniform(0, 10), -4000},
                  unit({rng.uniform(-1e-4, 1e-4), rng.uniform(-1e-4, 1e-4), 1})};
    ASSERT_EQ(caster.first_hit(ray, endless), by_brute_force(meshes, ray, endless));
  }
}

TEST(RayCaster, AsksNothingOfTheHeap) {
  const auto meshes = made_up_scene();
  const RayCaster caster(meshes);
  const auto rays = rays_at(meshes, 1000);
  std::vector<std::optional<CastHit>> hits(rays.size());
  caster.first_hits(rays, endless, hits);
  const std::size_t before = bench::allocations();
  caster.first_hits(rays, endless, hits);
  EXPECT_EQ(bench::allocations(), before);
}

TEST(RayCaster, AMeshWithAHoleInItsNumbersIsABug) {
  std::vector<TriangleMesh> meshes{level_mesh({0, 0, 0}, 1, 1, 1)};
  meshes[0].triangles.push_back({0, 1, 4});
  EXPECT_THROW(RayCaster{meshes}, ContractViolation);
  meshes[0].triangles.pop_back();
  meshes[0].corners[2][1] = std::numeric_limits<float>::infinity();
  EXPECT_THROW(RayCaster{meshes}, ContractViolation);
}

}  // namespace
}  // namespace slackwater::twin::ray_caster_test
