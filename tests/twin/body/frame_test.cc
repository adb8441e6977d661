#include "twin/body/frame.h"

#include <gtest/gtest.h>

#include <cmath>

namespace slackwater::twin::frame_test {
namespace {

TEST(TwinFrame, NorthIsNorthAndDownIsNotUp) {
  const Vector3<Enu> enu = enu_of({1, 2, 3});  // north, east, down
  EXPECT_EQ(enu.eigen(), Eigen::Vector3d(2, 1, -3));
  const Triple<double> back = ned_of(enu);
  EXPECT_EQ(back.x, 1);
  EXPECT_EQ(back.y, 2);
  EXPECT_EQ(back.z, 3);
  const double kernel[3] = {2, 1, -3};
  EXPECT_EQ(ned_of(kernel).x, 1);
  EXPECT_EQ(ned_of(kernel).z, 3);
  EXPECT_EQ(height_of({1, 2, 3}), -3);
}

TEST(TwinFrame, TheLevelPartIsEastAndINorth) {
  EXPECT_EQ(horizontal_of({1, 2, 3}), Horizontal(2, 1));
  const Triple<double> level = ned_of(Horizontal(2, 1));
  EXPECT_EQ(level.x, 1);
  EXPECT_EQ(level.y, 2);
  EXPECT_EQ(level.z, 0);
  EXPECT_FALSE(std::signbit(level.z));
}

TEST(TwinFrame, TheSurfaceIsThatOfTheOtherSide) {
  // Logs hold it so: a zero that is turned round has its sign turned round.
  EXPECT_TRUE(std::signbit(enu_of({0, 0, 0}).z()));
  EXPECT_TRUE(std::signbit(height_of({0, 0, 0})));
}

}  // namespace
}  // namespace slackwater::twin::frame_test
