#include "twin/clearance/cell.h"

#include <gtest/gtest.h>

#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"

namespace slackwater::twin::cell_test {
namespace {

Planar random_place(Rng& rng, double within_m) {
  return {rng.uniform(-within_m, within_m), rng.uniform(-within_m, within_m)};
}
Planar along(double bearing_rad) { return {std::cos(bearing_rad), std::sin(bearing_rad)}; }

TEST(NearestPlaces, NoOtherTwoPlacesOfTheStretchesAreNearer) {
  for (int seed = 0; seed < 300; ++seed) {
    Rng rng(7, "nearest/" + std::to_string(seed));
    // Points and stretches that touch are among them.
    Stretch a{random_place(rng, 5), random_place(rng, 5)};
    Stretch b{random_place(rng, 5), random_place(rng, 5)};
    if (seed % 5 == 0) a.to = a.from;
    if (seed % 7 == 0) b.from = a.to;
    const NearestPlaces found = nearest_places(a, b);
    const double least = size_of(found.on_a - found.on_b);
    double sampled = 1e9;
    for (int i = 0; i <= 60; ++i)
      for (int j = 0; j <= 60; ++j)
        sampled = std::min(sampled, size_of(a.from + (i / 60.0) * (a.to - a.from) - b.from -
                                            (j / 60.0) * (b.to - b.from)));
    EXPECT_LE(least, sampled + 1e-12) << seed;
    EXPECT_GE(least, sampled - 0.3) << seed;  // of the sampling
    EXPECT_LT(size_of(found.on_a - nearest_on(a, found.on_a)), 1e-9) << seed;
    EXPECT_LT(size_of(found.on_b - nearest_on(b, found.on_b)), 1e-9) << seed;
  }
}

/// Of all places that a nearest one can be (the wanted one, its feet, where two planes meet) the
/// nearest that is in the cell: cubic in the planes, and right without a thought.
bool nearest_of_all(const Cell& cell, const Planar& wanted, Planar& nearest) {
  std::vector<Planar> places{wanted};
  const auto planes = cell.planes();
  for (std::size_t i = 0; i < planes.size(); ++i) {
    places.push_back(wanted + planes[i].room_m(wanted) * planes[i].normal);
    for (std::size_t j = 0; j < i; ++j) {
      const Planar &a = planes[i].normal, &b = planes[j].normal;
      const double across = a.north * b.east - a.east * b.north;
      if (across == 0) continue;
      places.push_back({(planes[i].limit_m * b.east - planes[j].limit_m * a.east) / across,
                        (planes[j].limit_m * a.north - planes[i].limit_m * b.north) / across});
    }
  }
  double least = 1e300;
  for (const Planar& place : places) {
    bool is_in = true;
    for (const Plane& plane : planes) is_in = is_in && plane.room_m(place) > -1e-7;
    if (!is_in || size_of(place - wanted) >= least) continue;
    least = size_of(place - wanted);
    nearest = place;
  }
  return least < 1e300;
}

TEST(NearestInACell, IsTheNearestOfAllPlacesWhereOneCanBe) {
  int empty = 0;
  for (int seed = 0; seed < 1000; ++seed) {
    Rng rng(7, "cell/" + std::to_string(seed));
    Cell cell;
    const int planes = static_cast<int>(rng.uniform(0, 9));
    for (int i = 0; i < planes; ++i)
      cell.add({along(rng.uniform(0, 2 * constants::pi)), rng.uniform(-1, 4), Plane::fixed}, {});
    const Planar wanted = random_place(rng, 8);
    Planar found, expected;
    const bool has_room = nearest_in(cell, wanted, found);
    ASSERT_EQ(has_room, nearest_of_all(cell, wanted, expected)) << seed;
    empty += has_room ? 0 : 1;
    if (has_room) {
      EXPECT_NEAR(size_of(found - wanted), size_of(expected - wanted), 1e-6) << seed;
    }
  }
  EXPECT_GT(empty, 20);
}

TEST(ACell, WithMorePlanesThanItHoldsKeepsTheNearestAndSaysSo) {
  Cell cell;
  for (std::size_t i = 0; i < most_planes; ++i) cell.add({{1, 0}, 100.0 + double(i), -1}, {});
  EXPECT_FALSE(cell.is_crowded());
  cell.add({{1, 0}, 3, Plane::fixed}, {});
  cell.add({{1, 0}, 1000, Plane::fixed}, {});
  EXPECT_TRUE(cell.is_crowded());
  Claim claim;
  EXPECT_DOUBLE_EQ(cell.room_m(claim), 3);
  double most = 0;
  for (const Plane& plane : cell.planes()) most = std::max(most, plane.limit_m);
  EXPECT_DOUBLE_EQ(most, 100.0 + most_planes - 2) << "the farthest has made room";
}

}  // namespace
}  // namespace slackwater::twin::cell_test
