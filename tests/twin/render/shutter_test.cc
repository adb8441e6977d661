#include "twin/render/lens/shutter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/twin/render/ranging_for_tests.h"
#include "twin/inspection/instrument/quality.h"
#include "twin/render/frame/truth_frame.h"

namespace slackwater::twin::shutter_test {
namespace {

constexpr int wide = 160, high = 60;
constexpr double away_m = 4;

/// A wall, and a picture of it that is bright to the right of a column.
struct Edge {
  Cast cast{wall_mesh(away_m)};
  Pose pose = looking({0, 0, 0}, {1, 0, 0});
  FrameHits hits;
  LightFrame light;

  explicit Edge(double at_column) {
    (void)truth_of(cast.scene, camera(), 100, 1, hits);
    light.wide = wide;
    light.high = high;
    for (int j = 0; j < high; ++j)
      for (int i = 0; i < wide; ++i) {
        const auto bright = static_cast<float>(std::clamp(i + 1 - at_column, 0.0, 1.0));
        light.light.push_back({bright, 2 * bright, 3 * bright});
      }
  }
  [[nodiscard]] Pinhole camera() const { return {pose, frame_of(wide, high, 60)}; }
  [[nodiscard]] LightFrame through(const Shutter& shutter, int threads = 1) const {
    return through_shutter(light, shutter, camera(), pose, hits, threads);
  }
};

/// Where the edge of a row is: how far from the right the row is bright in all.
double edge_of_row(const LightFrame& frame, int row) {
  double bright = 0;
  for (int i = 0; i < wide; ++i) bright += frame.light[static_cast<std::size_t>(row * wide + i)][0];
  return wide - bright;
}
/// How wide it is smeared: a ramp of the width W holds W/4 of light on its dark side in all.
double width_of_row(const LightFrame& frame, int row, double at_column) {
  double off = 0;
  for (int i = 0; i < wide; ++i) {
    const double bright =
        static_cast<double>(frame.light[static_cast<std::size_t>(row * wide + i)][0]);
    off += i < at_column ? bright : 1 - bright;
  }
  return 4 * off;
}

// f v t/z, and the same as the inspection's blur on the wall, seen as so many pixels.
TEST(Shutter, SmearIsFocalLengthTimesWayOverDepth) {
  Edge edge(80);
  const double focal = edge.camera().focal_u();
  for (const double speed_m_s : {0.5, -1.0, 2.0}) {
    edge.pose.velocity_m_s = {0, speed_m_s, 0};
    const Shutter shutter{0.4, 0};
    const double smear_px = focal * std::abs(speed_m_s) * 0.4 / away_m;
    const LightFrame blurred = edge.through(shutter);
    for (const int row : {3, 30, 55}) {
      EXPECT_NEAR(width_of_row(blurred, row, 80), smear_px, 0.02 * smear_px + 0.1) << speed_m_s;
      EXPECT_NEAR(edge_of_row(blurred, row), 80, 0.05) << "its middle stays";
    }
    Instrument instrument;
    FrameFootprint footprint = frame_of(wide, high, 60);
    footprint.exposure_s = 0.4;
    instrument.footprint = footprint;
    instrument.least_range_m = 0.1;
    instrument.most_range_m = 100;
    const auto quality = quality_of(instrument, edge.pose, {}, {away_m, 0, 0}, {-1, 0, 0});
    ASSERT_TRUE(quality);
    EXPECT_NEAR(quality->blur_m * focal / away_m, smear_px, 1e-9);
  }
}

TEST(Shutter, ATurnSmearsByTheFocalLengthWhateverTheRange) {
  Edge edge(80);
  edge.pose.turning_rad_s = {0, 0, 0.4};  // to the right
  const double smear_px = edge.camera().focal_u() * 0.4 * 0.1;
  EXPECT_NEAR(width_of_row(edge.through({0.1, 0}), 30, 80), smear_px, 0.02 * smear_px + 0.1);
  const auto motion = image_motion_px_s(edge.camera(), edge.pose, {7, 0, 0});
  EXPECT_NEAR(motion[0], -edge.camera().focal_u() * 0.4, 1e-9) << "what is seen goes left";
  EXPECT_NEAR(motion[1], 0, 1e-9);
}

// Against the projection of the place a millisecond later.
TEST(Shutter, MotionIsThatOfTheProjection) {
  Pose pose = looking({1, 2, 3}, {4, 2.5, 4});
  pose.velocity_m_s = {0.4, -0.3, 0.2};
  pose.turning_rad_s = {0.1, -0.2, 0.3};
  const Pinhole camera(pose, frame_of(wide, high, 60));
  const Triple<double> place{5, 3, 4.2};
  constexpr double step_s = 1e-6;
  const auto place_after = [&](double t_s) {
    Pose then = pose;
    then.position_m = pose.position_m + t_s * pose.velocity_m_s;
    then.axis = pose.axis + t_s * cross(pose.turning_rad_s, pose.axis);
    then.right = pose.right + t_s * cross(pose.turning_rad_s, pose.right);
    return *Pinhole(then, frame_of(wide, high, 60)).place_of(place);
  };
  const auto motion = image_motion_px_s(camera, pose, place - pose.position_m);
  const PixelPlace before = place_after(-step_s), after = place_after(step_s);
  EXPECT_NEAR(motion[0], (after.u - before.u) / (2 * step_s), 1e-4);
  EXPECT_NEAR(motion[1], (after.v - before.v) / (2 * step_s), 1e-4);
}

// Row j sees the edge where it is at t_j: the edge leans by f v/z line times.
TEST(Shutter, ARollingShutterLeansWhatGoesPast) {
  Edge edge(80);
  edge.pose.velocity_m_s = {0, 1, 0};
  const Shutter shutter{0, 2e-3};
  const LightFrame leaning = edge.through(shutter);
  const double runs_px_s = -edge.camera().focal_u() * 1 / away_m;
  for (int row = 0; row < high; row += 7) {
    const double t_s = (row + 0.5 - 0.5 * high) * 2e-3;
    EXPECT_NEAR(edge_of_row(leaning, row), 80 + runs_px_s * t_s, 0.05) << row;
  }
  EXPECT_NEAR(edge_of_row(leaning, 0) - edge_of_row(leaning, high - 1),
              -runs_px_s * (high - 1) * 2e-3, 0.1);
}

TEST(Shutter, WhatStandsStillStaysAsItIs) {
  const Edge edge(80.3);
  EXPECT_EQ(edge.through({0.5, 1e-3}).light, edge.light.light);
}

TEST(Shutter, IsTheSameOnAnyNumberOfThreads) {
  Edge edge(70.7);
  edge.pose.velocity_m_s = {0.3, 1, 0.1};
  edge.pose.turning_rad_s = {0.1, 0.2, 0.3};
  const LightFrame one = edge.through({0.05, 1e-3});
  EXPECT_NE(one.light, edge.light.light);
  EXPECT_EQ(one.light, edge.through({0.05, 1e-3}, 2).light);
}

}  // namespace
}  // namespace slackwater::twin::shutter_test
