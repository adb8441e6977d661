// A camera in somebody's hand: where it then looks, and what is seen in other water.
#include "twin/inspection/instrument/pointing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/twin/inspection/inspection_for_tests.h"
#include "twin/inspection/instrument/clarity.h"

namespace slackwater::twin::pointing_test {
namespace {

using tests::degree;
using tests::InspectionFolder;
using tests::level;

constexpr CameraPointing ahead{};

Pose straight(const Carriage& carriage) {
  Pose pose;
  pose.position_m = carriage.position_m;
  pose.axis = carriage.attitude.to_ned({1, 0, 0});
  pose.right = carriage.attitude.to_ned({0, 1, 0});
  return pose;
}

void expect_near(const Triple<double>& found, const Triple<double>& expected) {
  EXPECT_NEAR(length_of(found - expected), 0, 1e-12);
}

TEST(Pointing, PansToStarboardAndTiltsUp) {
  const Carriage north = level({0, 0, 10}, 0);
  const Pose east = pointed(straight(north), north, {90 * degree, 0, 1});
  expect_near(east.axis, {0, 1, 0});
  expect_near(east.right, {-1, 0, 0});
  expect_near(pointed(straight(north), north, {0, 90 * degree, 1}).axis, {0, 0, -1});
  // Both: the pan goes first, and the picture stays level.
  const Pose both = pointed(straight(north), north, {90 * degree, 30 * degree, 1});
  expect_near(both.axis, {0, std::cos(30 * degree), -std::sin(30 * degree)});
  EXPECT_NEAR(both.right.z, 0, 1e-12);
  EXPECT_NEAR(dot(both.axis, both.right), 0, 1e-12);
  // About the vehicle's own axes: one that heels 90 degrees to starboard pans downwards.
  EulerAngles heeled;
  heeled.roll_rad = 90 * degree;
  const Carriage carriage{{}, rotation_of(attitude_of(heeled)), {}, {}};
  expect_near(pointed(straight(carriage), carriage, {90 * degree, 0, 1}).axis, {0, 0, 1});
}

TEST(Pointing, ZoomNarrowsTheFieldByTheFocalLength) {
  Instrument camera;
  camera.footprint = FrameFootprint{1.2, 0.9, 4000, 3000, 0.01};
  zoom_in(3, camera);
  const auto& frame = std::get<FrameFootprint>(camera.footprint);
  EXPECT_NEAR(std::tan(frame.horizontal_rad / 2), std::tan(0.6) / 3, 1e-12);
  EXPECT_NEAR(std::tan(frame.vertical_rad / 2), std::tan(0.45) / 3, 1e-12);
  EXPECT_EQ(frame.pixels_wide, 4000);
}

/// What a camera that stands 3 m before a wall covers of it.
double covered(const Sight& sight) {
  const InspectionFolder folder;
  folder.add("camera",
             "kind: rgb\nrange_m: [0.3, 30]\naim: {axis: [1, 0, 0]}\nframe: {horizontal_deg: 40, "
             "vertical_deg: 40, pixels_wide: 4000, pixels_high: 4000, exposure_s: 0.001}\n");
  const auto inspection = folder.made(
      "surfaces: [{kind: cable, route: [{north_m: 3, east_m: -10, depth_m: 10}, {north_m: 3, "
      "east_m: 10, depth_m: 10}], burial_m: 0, corridor_m: 0.5, off_ends_m: 0, patch_m: 0.1}]\n"
      "water: {visibility_m: 20}\n"
      "looks: [{instrument: camera, kinds: [cable], detail_mm: 30}]\n",
      {{{0, 0, 8}, 1}});
  InspectionState state = begin_inspection(*inspection, 1);
  const Carriage carriage = level({0, 0, 8}, 0);
  inspect(*inspection, true, carriage, carriage.position_m, 0, 0.1, state, sight);
  return tests::covered_share(*inspection, state);
}

TEST(Pointing, WhatIsSeenIsWhereTheCameraLooks) {
  const CameraPointing at_it{0, -std::atan2(2.0, 3.0), 1};
  const double seen = covered({{}, {}, at_it});
  EXPECT_GT(seen, 0.05);
  EXPECT_LT(seen, 0.25);
  EXPECT_EQ(covered({{}, {}, {180 * degree, 0, 1}}), 0) << "it looks away";
  const double zoomed = covered({{}, {}, {0, at_it.tilt_rad, 2}});
  EXPECT_GT(zoomed, 0.3 * seen);
  EXPECT_LT(zoomed, 0.7 * seen) << "half as wide";
}

TEST(Pointing, InMurkyWaterNothingIsMadeOut) {
  const CameraPointing at_it{0, -std::atan2(2.0, 3.0), 1};
  EXPECT_EQ(covered({0.3, {}, at_it}), 0);
  EXPECT_GT(covered({20.0, {}, at_it}), 0);
  const Clarity murky = seen_through({}, 2, Medium::water);
  EXPECT_DOUBLE_EQ(murky.beam_attenuation_per_m, beam_attenuation_of_water(2));
  EXPECT_DOUBLE_EQ(murky.diffuse_attenuation_per_m, murky.beam_attenuation_per_m / 4);
  EXPECT_EQ(murky.daylight, 1);
}

}  // namespace
}  // namespace slackwater::twin::pointing_test
