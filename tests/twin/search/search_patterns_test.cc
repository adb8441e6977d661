#include "twin/search/search_patterns.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"

namespace slackwater::tests {
namespace {

using twin::Triple;
using twin::Waypoint;

double course_of(const Waypoint& a, const Waypoint& b) {
  return std::atan2(b.position_m.y - a.position_m.y, b.position_m.x - a.position_m.x);
}
double length_of_leg(const Waypoint& a, const Waypoint& b) {
  return std::hypot(b.position_m.x - a.position_m.x, b.position_m.y - a.position_m.y);
}

TEST(SectorSearch, TurnsRightByOneHundredAndTwentyDegreesAndGoesStraightOverItsDatum) {
  const Triple<double> datum{100, -50, 2};
  const std::vector<Waypoint> points = twin::sector_search(datum, 400, 3, 0.3, 2);
  ASSERT_EQ(points.size(), 10U);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    EXPECT_NEAR(length_of_leg(points[i], points[i + 1]), 400, 1e-9);
    EXPECT_EQ(points[i].position_m.z, 2);
    if (i + 2 >= points.size()) break;
    const double turn = std::remainder(
        course_of(points[i + 1], points[i + 2]) - course_of(points[i], points[i + 1]),
        2 * constants::pi);
    EXPECT_NEAR(turn, i % 3 == 2 ? 0 : 2 * constants::pi / 3, 1e-9) << i;
  }
  for (const std::size_t i : {0U, 3U, 6U, 9U})
    EXPECT_NEAR(length_of_leg(points[i], points[0]), 0, 1e-9);
  // Straight on once more it would be on the course it began with.
  EXPECT_NEAR(std::remainder(course_of(points[8], points[9]) - 0.3, 2 * constants::pi), 0, 1e-9);
}

TEST(ParallelSweep, LeavesNoPlaceFartherThanHalfASpacingFromALine) {
  for (const double width_m : {300.0, 310.0, 20.0}) {
    const std::vector<Waypoint> points =
        twin::parallel_sweep({1000, 2000, 0}, 0, 800, width_m, 100, 3);
    const auto lines = static_cast<double>(points.size() / 2);
    EXPECT_EQ(lines, std::ceil(width_m / 100));
    for (const Waypoint& point : points) {
      EXPECT_NEAR(std::abs(point.position_m.x - 1000), 400, 1e-9);
      EXPECT_LE(std::abs(point.position_m.y - 2000), 0.5 * width_m * (1 - 1 / lines) + 1e-9);
    }
    EXPECT_NEAR(points.front().position_m.y, 2000 - 0.5 * width_m * (1 - 1 / lines), 1e-9);
    EXPECT_NEAR(points.back().position_m.y, 2000 + 0.5 * width_m * (1 - 1 / lines), 1e-9);
  }
}

}  // namespace
}  // namespace slackwater::tests
