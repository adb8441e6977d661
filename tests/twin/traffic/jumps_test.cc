#include "twin/traffic/jumps.h"

#include <gtest/gtest.h>

namespace slackwater::tests::jumps_test {
namespace {

using namespace twin;

/// At 5 m/s to the north, a report a minute, with some of them elsewhere.
std::vector<TrackPoint> steady(int reports) {
  std::vector<TrackPoint> points;
  for (int i = 0; i < reports; ++i) points.push_back({60.0 * i, {300.0 * i, 0, 0}, {}, {}});
  return points;
}

TEST(Jumps, AWayWithoutThemStaysWhole) {
  const std::vector<TrackPoint> points = steady(5);
  const SteadyPieces cut = cut_at_jumps(points);
  ASSERT_EQ(cut.pieces.size(), 1U);
  EXPECT_EQ(cut.pieces[0].size(), 5U);
  EXPECT_EQ(cut.strays, 0U);
  EXPECT_TRUE(cut.jumps.empty());
  EXPECT_TRUE(cut_at_jumps({}).pieces.empty());
}

TEST(Jumps, AStrayReportIsLeftOutWhereverItStands) {
  for (const std::size_t stray : {0U, 2U, 4U}) {
    std::vector<TrackPoint> points = steady(5);
    points[stray].position_m.y = 40e3;
    const SteadyPieces cut = cut_at_jumps(points);
    ASSERT_EQ(cut.pieces.size(), 1U) << stray;
    EXPECT_EQ(cut.pieces[0].size(), 4U) << stray;
    EXPECT_EQ(cut.strays, 1U) << stray;
    for (const TrackPoint& point : cut.pieces[0]) EXPECT_EQ(point.position_m.y, 0);
  }
}

TEST(Jumps, AWayThatGoesOnElsewhereIsTwo) {
  std::vector<TrackPoint> points = steady(6);
  for (std::size_t i = 3; i < 6; ++i) points[i].position_m.y = 7e3;
  const SteadyPieces cut = cut_at_jumps(points);
  ASSERT_EQ(cut.pieces.size(), 2U);
  EXPECT_EQ(cut.pieces[0].size(), 3U);
  EXPECT_EQ(cut.pieces[1].size(), 3U);
  ASSERT_EQ(cut.jumps.size(), 1U);
  EXPECT_EQ(cut.jumps[0].from_s, 120);
  EXPECT_EQ(cut.jumps[0].to_s, 180);
  EXPECT_NEAR(cut.jumps[0].distance_m, std::hypot(300, 7e3), 1e-9);
}

TEST(Jumps, TheFastestThatAisCanTellIsNone) {
  constexpr double limit_m = 100 + 52.6 * 60;
  std::vector<TrackPoint> points{
      {0, {0, 0, 0}, {}, {}}, {60, {limit_m - 0.1, 0, 0}, {}, {}}, {61, {limit_m, 0, 0}, {}, {}}};
  EXPECT_EQ(cut_at_jumps(points).pieces.size(), 1U);
  points[1].position_m.x = points[2].position_m.x = limit_m + 60;
  const SteadyPieces cut = cut_at_jumps(points);
  EXPECT_EQ(cut.pieces.front().size(), 2U);
  EXPECT_EQ(cut.strays, 1U);
}

}  // namespace
}  // namespace slackwater::tests::jumps_test
