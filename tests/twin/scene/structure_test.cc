#include "twin/scene/structure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"

namespace slackwater::twin::structure_test {
namespace {

using constants::pi;
using Point = Triple<double>;

/// A monopile of 8 m in 30 m of water that stands 15 m out of it.
const Cylinder monopile{100, -50, 4, -15, 30};
const Structure box = box_of({10, 20, 5}, {3, 2, 1}, 0.4);

Point random_point(Rng& random, const Point& about, double scale) {
  return about + Point{scale * random.normal(), scale * random.normal(), scale * random.normal()};
}
Point unit(const Point& p) { return (1 / std::sqrt(dot(p, p))) * p; }

TEST(Structures, AreAsFarAsTheirNearestPoint) {
  const Structure pile = monopile;
  EXPECT_NEAR(signed_distance_m(pile, {110, -50, 10}), 6, 1e-12);
  EXPECT_NEAR(signed_distance_m(pile, {100, -47, 10}), -1, 1e-12);
  EXPECT_NEAR(signed_distance_m(pile, {100, -50, 29.5}), -0.5, 1e-12);
  EXPECT_NEAR(signed_distance_m(pile, {107, -50, 34}), 5, 1e-12);  // 3, 4 from the edge
  EXPECT_NEAR(signed_distance_m(box, {10, 20, 9}), 3, 1e-12);
  const double c = std::cos(0.4), s = std::sin(0.4);
  EXPECT_NEAR(signed_distance_m(box, {10 + 6 * c, 20 + 6 * s, 5}), 3, 1e-12);
  EXPECT_NEAR(signed_distance_m(box, {10 - 6 * s, 20 + 6 * c, 5}), 4, 1e-12);
}

/// |grad d| = 1, and no step inside the distance meets the surface: what makes a distance a
/// distance.
TEST(Structures, TheDistanceGrowsAsOneMoves) {
  Rng random(1, "tests/structure_distance");
  for (const auto& [structure, about] :
       std::vector<std::pair<Structure, Point>>{{monopile, {100, -50, 20}}, {box, {10, 20, 5}}}) {
    for (int i = 0; i < 500; ++i) {
      const Point at = random_point(random, about, 8);
      const double d = signed_distance_m(structure, at);
      constexpr double h = 1e-6;
      Point slope;
      slope.x = (signed_distance_m(structure, at + Point{h, 0, 0}) - d) / h;
      slope.y = (signed_distance_m(structure, at + Point{0, h, 0}) - d) / h;
      slope.z = (signed_distance_m(structure, at + Point{0, 0, h}) - d) / h;
      EXPECT_NEAR(dot(slope, slope), 1, 1e-4) << i;
      const Point onward = at + std::abs(d) * unit(random_point(random, {}, 1));
      EXPECT_GE(signed_distance_m(structure, onward) * (d < 0 ? -1 : 1), -1e-9) << i;
    }
  }
}

/// Sphere tracing with the distance, which shares no line with the closed forms of the rays.
std::optional<double> traced(const Structure& structure, const Ray& ray) {
  double range = 0;
  for (int i = 0; i < 200000 && range < 1000; ++i) {
    const double d = signed_distance_m(structure, ray.from_m + range * ray.direction);
    if (d < 1e-7) return range;
    range += d;
  }
  return std::nullopt;
}

TEST(Rays, MeetStructuresWhereMarchingAlongThemDoes) {
  Rng random(2, "tests/structure_rays");
  int hits = 0, sides = 0, rays = 0;
  for (const auto& [structure, about] :
       std::vector<std::pair<Structure, Point>>{{monopile, {100, -50, 10}}, {box, {10, 20, 5}}}) {
    for (int i = 0; i < 2000; ++i) {
      const Point from = random_point(random, about, 15);
      if (signed_distance_m(structure, from) < 0.01) continue;
      const Ray ray{from, unit(random_point(random, about, 4) - from)};
      const std::optional<Hit> hit = first_hit(structure, ray);
      const std::optional<double> march = traced(structure, ray);
      ++rays;
      // A graze may go either way.
      if (hit.has_value() != march.has_value()) {
        const double near = least_distance_m(structure, from, from + 200.0 * ray.direction);
        EXPECT_NEAR(near, 0, 1e-6);
        continue;
      }
      if (!hit) continue;
      ++hits;
      EXPECT_NEAR(hit->range_m, *march, 1e-3) << i;
      EXPECT_NEAR(dot(hit->normal, hit->normal), 1, 1e-12);
      EXPECT_GT(hit->squareness(ray), 0);
      sides += std::abs(hit->normal.z) < 0.5;
      const Point at = from + hit->range_m * ray.direction;
      EXPECT_NEAR(signed_distance_m(structure, at + 0.001 * hit->normal), 0.001, 1e-9);
    }
  }
  EXPECT_GT(hits, rays / 10);
  EXPECT_LT(hits, rays);
  EXPECT_GT(sides, 0);
  EXPECT_LT(sides, hits);
}

TEST(Rays, FromInsideOrAwayMeetNothing) {
  const Structure pile = monopile;
  EXPECT_FALSE(first_hit(pile, Ray{{100, -50, 10}, {1, 0, 0}}));
  EXPECT_FALSE(first_hit(pile, Ray{{110, -50, 10}, {1, 0, 0}}));
  EXPECT_FALSE(first_hit(pile, Ray{{110, -50, 10}, {0, 0, 1}}));
  EXPECT_NEAR(first_hit(pile, Ray{{102, -50, -40}, {0, 0, 1}})->range_m, 25, 1e-12);
}

TEST(Rays, MeetTheNearestOfAllThatIsAround) {
  const std::vector<Structure> structures{monopile, box};
  const Scene around{structures, 30, 0};
  EXPECT_NEAR(first_hit(around, Ray{{90, -50, 10}, {1, 0, 0}})->range_m, 6, 1e-12);
  EXPECT_NEAR(first_hit(around, Ray{{90, -50, 10}, {0, 0, 1}})->range_m, 20, 1e-12);
  EXPECT_NEAR(first_hit(around, Ray{{90, -50, 10}, {0, 0, -1}})->range_m, 10, 1e-12);
  EXPECT_FALSE(first_hit(around, Ray{{90, -50, 10}, {-1, 0, 0}}));
  const double slant = std::sqrt(0.5);
  EXPECT_NEAR(first_hit(around, Ray{{90, -50, 28}, {slant, 0, slant}})
                  ->squareness(Ray{{}, {slant, 0, slant}}),
              slant, 1e-12);
}

TEST(Ways, ThroughAStructureAreTold) {
  const Structure pile = monopile;
  EXPECT_NEAR(least_distance_m(pile, {50, -50, 10}, {150, -50, 10}), -4, 1e-9);
  EXPECT_NEAR(least_distance_m(pile, {50, -43, 10}, {150, -43, 10}), 3, 1e-9);
  EXPECT_NEAR(least_distance_m(pile, {110, -43, 10}, {150, -43, 10}), std::hypot(10, 7) - 4, 1e-9);
  Rng random(3, "tests/structure_ways");
  for (int i = 0; i < 200; ++i) {
    const Point a = random_point(random, {10, 20, 5}, 5), b = random_point(random, {10, 20, 5}, 5);
    double least = 1e9;
    for (int k = 0; k <= 2000; ++k)
      least = std::min(least, signed_distance_m(box, a + (k / 2000.0) * (b - a)));
    const double found = least_distance_m(box, a, b);
    EXPECT_LE(found, least + 1e-9);
    EXPECT_NEAR(found, least, 0.01) << i;
  }
}

}  // namespace
}  // namespace slackwater::twin::structure_test
