#include "fields/geo/coverage.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"

namespace slackwater::coverage_test {
namespace {

TEST(BoxesOverlap, WhateverTheConventionOfTheirLongitudes) {
  const BoundingBox fiji{177, -20, -178, -15};          // across the antimeridian
  const BoundingBox fiji_past_180{177, -20, 182, -15};  // the same
  const BoundingBox samoa{-173, -15, -171, -13};
  const BoundingBox globe{-180, -90, 180, 90};
  const BoundingBox globe_360{0, -90, 360, 90};
  EXPECT_TRUE(overlaps(fiji, {179, -18, 179.5, -17}));
  EXPECT_TRUE(overlaps(fiji, {-179, -18, -178.5, -17}));
  EXPECT_TRUE(overlaps(fiji_past_180, {-179, -18, -178.5, -17}));
  EXPECT_FALSE(overlaps(fiji, samoa));
  EXPECT_FALSE(overlaps(fiji_past_180, {-177.9, -18, 176.9, -17}));
  for (const BoundingBox& box : {fiji, fiji_past_180, samoa}) {
    EXPECT_TRUE(overlaps(globe, box));
    EXPECT_TRUE(overlaps(box, globe_360));
  }
  EXPECT_TRUE(overlaps({350, 50, 355, 60}, {-8, 55, -6, 56}));
}

TEST(BoxesOverlap, Symmetrically) {
  Rng rng(1, "boxes");
  for (int i = 0; i < 1000; ++i) {
    const auto box = [&] {
      const double west = rng.uniform(-180, 360);
      const double south = rng.uniform(-90, 80);
      return BoundingBox{west, south, west + rng.uniform(0, 200), south + rng.uniform(0, 10)};
    };
    const BoundingBox a = box();
    const BoundingBox b = box();
    EXPECT_EQ(overlaps(a, b), overlaps(b, a));
    EXPECT_TRUE(overlaps(a, a));
  }
}

/// Independent: a point at a bearing and distance on the sphere.
TEST(WidenedBox, HoldsEveryPointWithinTheMargin) {
  Rng rng(2, "margins");
  constexpr double degree = constants::pi / 180;
  for (int i = 0; i < 5000; ++i) {
    const double latitude_deg = rng.uniform(-89.9, 89.9);
    const double longitude_deg = rng.uniform(-180, 180);
    const double margin_km = rng.uniform(0, i % 2 == 0 ? 50 : 3000);
    const double way = rng.uniform() * margin_km * 1000 / constants::earth_radius_m;
    const double bearing = rng.uniform(0, 2 * constants::pi);
    const double sine = std::sin(latitude_deg * degree) * std::cos(way) +
                        std::cos(latitude_deg * degree) * std::sin(way) * std::cos(bearing);
    const double there_deg = std::asin(sine) / degree;
    const double east_deg =
        longitude_deg +
        std::atan2(std::sin(bearing) * std::sin(way) * std::cos(latitude_deg * degree),
                   std::cos(way) - std::sin(latitude_deg * degree) * sine) /
            degree;
    const BoundingBox point{longitude_deg, latitude_deg, longitude_deg, latitude_deg};
    const BoundingBox there{east_deg, there_deg, east_deg, there_deg};
    EXPECT_TRUE(overlaps(widened(point, margin_km), there))
        << latitude_deg << " " << longitude_deg << " " << margin_km << " km";
  }
}

TEST(WidenedBox, GoesRoundTheEarthAtAPole) {
  EXPECT_TRUE(overlaps(widened({10, 89.95, 10, 89.95}, 10), {-170, 89.95, -170, 89.95}));
  EXPECT_EQ(widened({10, 20, 30, 40}, 0), (BoundingBox{10, 20, 30, 40}));
}

}  // namespace
}  // namespace slackwater::coverage_test
