#include "api/door/edr/read/geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "api/door/edr/read/wkt.h"

namespace slackwater::api::edr::geometry_test {
namespace {

Geometry of(const std::string& wkt) { return parse_wkt("coords", wkt); }

TEST(Geometry, APolygonHoldsItsInsideAndItsBorderButNotItsHole) {
  const Geometry square = of("POLYGON((0 0,10 0,10 10,0 10,0 0),(4 4,6 4,6 6,4 6,4 4))");
  EXPECT_TRUE(contains(square, 2, 2));
  EXPECT_TRUE(contains(square, 0, 5)) << "border";
  EXPECT_TRUE(contains(square, 10, 10)) << "corner";
  EXPECT_TRUE(contains(square, 4, 5)) << "border of the hole";
  EXPECT_FALSE(contains(square, 5, 5)) << "hole";
  EXPECT_FALSE(contains(square, 10.000001, 5));
  EXPECT_FALSE(contains(square, 5, -0.000001));
  EXPECT_FALSE(contains(square, std::nan(""), 5));
}

TEST(Geometry, OneOfSeveralPolygonsSuffices) {
  const Geometry two = of("MULTIPOLYGON(((0 0,1 0,1 1,0 0)),((5 5,6 5,6 6,5 5)))");
  EXPECT_TRUE(contains(two, 0.5, 0.25));
  EXPECT_TRUE(contains(two, 5.5, 5.25));
  EXPECT_FALSE(contains(two, 3, 3));
}

TEST(Geometry, LongitudesThatDifferByATurnAreOnePlace) {
  const Geometry across = of("POLYGON((175 -20,185 -20,185 -10,175 -10,175 -20))");
  for (const double longitude : {178.0, -178.0, 182.0, -182.0, 180.0, -180.0}) {
    EXPECT_TRUE(contains(across, longitude, -15)) << longitude;
  }
  EXPECT_FALSE(contains(across, -174, -15));
  EXPECT_FALSE(contains(across, 0, -15));
  EXPECT_TRUE(contains(bounding_box(across), -178, -15));
  EXPECT_FALSE(contains(bounding_box(across), 0, -15));
  const Geometry by_0_360 = of("POLYGON((350 50,359 50,359 60,350 60,350 50))");
  EXPECT_TRUE(contains(by_0_360, -5, 55));
}

TEST(Geometry, TheWholeGlobeHoldsEveryPlace) {
  const Geometry globe = of("POLYGON((-180 -90,180 -90,180 90,-180 90,-180 -90))");
  EXPECT_TRUE(contains(globe, 0, 0));
  EXPECT_TRUE(contains(globe, 180, 90));
  EXPECT_TRUE(contains(globe, 359, -90));
}

TEST(Geometry, PointsAndLinesHoldNothing) {
  EXPECT_FALSE(contains(of("POINT(2 57)"), 2, 57));
  EXPECT_FALSE(contains(of("LINESTRING(0 0,2 0,2 2,0 0)"), 1, 0));
}

TEST(Geometry, TheBoxIsThatOfAllVertices) {
  EXPECT_EQ(bounding_box(of("MULTIPOLYGON(((0 0,1 0,1 1,0 0)),((5 5,6 5,6 -6,5 5)))")),
            (Box{0, -6, 6, 5}));
  EXPECT_EQ(bounding_box(of("POINT(-2.5 57)")), (Box{-2.5, 57, -2.5, 57}));
}

/// Oracle: the winding number by angles, which shares no step with the crossing of edges.
double turns_around(const Path& ring, double x, double y) {
  double angle = 0;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
    const double ax = ring[i].longitude_deg - x;
    const double ay = ring[i].latitude_deg - y;
    const double bx = ring[i + 1].longitude_deg - x;
    const double by = ring[i + 1].latitude_deg - y;
    angle += std::atan2(ax * by - ay * bx, ax * bx + ay * by);
  }
  return angle / (2 * std::acos(-1.0));
}

TEST(Geometry, StarShapedPolygonsAgreeWithTheWindingNumber) {
  std::mt19937_64 random(4);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11U) * 0x1p-53;
  };
  std::size_t inside = 0;
  for (int polygon = 0; polygon < 200; ++polygon) {
    Geometry star{GeometryType::polygon, false, false, {{{}}}};
    Path& ring = star.parts[0][0];
    const auto corners = static_cast<std::size_t>(uniform(3, 20));
    for (std::size_t i = 0; i < corners; ++i) {
      const double angle =
          2 * std::acos(-1.0) * static_cast<double>(i) / static_cast<double>(corners);
      const double radius = uniform(0.5, 20);
      ring.push_back({20 + radius * std::cos(angle), 30 + radius * std::sin(angle), 0, {}});
    }
    if (polygon % 2 == 1) std::reverse(ring.begin(), ring.end());
    ring.push_back(ring.front());
    for (int point = 0; point < 50; ++point) {
      const double x = uniform(0, 40);
      const double y = uniform(10, 50);
      const bool expected = std::abs(turns_around(ring, x, y)) > 0.5;
      inside += expected ? 1 : 0;
      EXPECT_EQ(contains(star, x, y), expected) << "polygon " << polygon << " at " << x << ' ' << y;
    }
  }
  EXPECT_GT(inside, 500U);
}

}  // namespace
}  // namespace slackwater::api::edr::geometry_test
