// The ways of vessels round what they keep out of.
#include "api/ask/plan/sea_way.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace slackwater::tests::sea_way_test {
namespace {

using namespace slackwater::api;

/// Metres north and east of a place of the North Sea, on the ellipsoid to a part in a thousand.
GeoPoint at_m(double east_m, double north_m) {
  return GeoPoint::from_degrees(54 + north_m / 111300, 6 + east_m / (111320 * 0.5888));
}

ConstraintArea square(double half_m) {
  ConstraintArea area;
  area.id = "square";
  area.corners = {at_m(-half_m, -half_m), at_m(half_m, -half_m), at_m(half_m, half_m),
                  at_m(-half_m, half_m)};
  return area;
}

TEST(SeaWay, IsStraightWhereNothingLiesBetween) {
  const GeoPoint a = at_m(-3000, 2000), b = at_m(3000, 2000);
  EXPECT_EQ(sea_way_m(a, b, {}), distance_m(a, b));
  EXPECT_EQ(sea_way_m(a, b, {square(1000)}), distance_m(a, b));
}

TEST(SeaWay, GoesByTwoCornersRoundASquare) {
  // To a corner 50 m off, along the side, and on: worked out by hand.
  const double off = 1000 + 50 / std::sqrt(2.0);
  const double expected = 2 * std::hypot(3000 - off, off) + 2 * off;
  for (const bool is_turned : {false, true}) {
    ConstraintArea area = square(1000);
    if (is_turned) std::reverse(area.corners.begin(), area.corners.end());
    EXPECT_NEAR(sea_way_m(at_m(-3000, 0), at_m(3000, 0), {area}), expected, 0.003 * expected);
    EXPECT_NEAR(sea_way_m(at_m(3000, 0), at_m(-3000, 0), {area}), expected, 0.003 * expected);
  }
}

TEST(SeaWay, TakesTheShorterSideOfAWall) {
  ConstraintArea wall;
  wall.corners = {at_m(-100, -1000), at_m(100, -1000), at_m(100, 9000), at_m(-100, 9000)};
  const GeoPoint a = at_m(-3000, 0), b = at_m(3000, 0);
  const double way = sea_way_m(a, b, {wall});
  EXPECT_GT(way, distance_m(a, b));
  EXPECT_LT(way, 1.08 * distance_m(a, b)) << "by the south, not by the north";
}

TEST(SeaWay, IsStraightOutOfAnAreaThatOneLiesIn) {
  EXPECT_EQ(sea_way_m(at_m(0, 0), at_m(3000, 0), {square(1000)}),
            distance_m(at_m(0, 0), at_m(3000, 0)));
}

TEST(SeaWay, ClosesExclusionAreasOnTheDaysThatTheyAreInForce) {
  ConstraintArea birds = square(1000);
  birds.months = Span{4, 7};
  birds.hours_utc = Span{3, 5};
  ConstraintArea lane = square(1000);
  lane.kind = AreaKind::traffic_lane;
  const UtcTime june = parse_utc("2025-06-02T00:00:00Z"),
                august = parse_utc("2025-08-02T00:00:00Z");
  const auto day = std::chrono::hours(24);
  EXPECT_EQ(closed_areas({birds, lane}, june, june + day).size(), 1U);
  EXPECT_TRUE(closed_areas({birds, lane}, august, august + day).empty());
  EXPECT_TRUE(closed_areas({birds}, june + std::chrono::hours(6), june + day).empty());
}

}  // namespace
}  // namespace slackwater::tests::sea_way_test
