#include "twin/render/frame/stereo.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/twin/render/ranging_for_tests.h"

namespace slackwater::twin::stereo_test {
namespace {

constexpr double baseline_m = 0.3;

struct Pair {
  Pinhole left, right;
  TruthFrame truth, of_right;
  StereoTruth stereo;

  explicit Pair(const Cast& cast, int threads = 1)
      : left(pose(), frame_of(96, 64, 60)),
        right(right_of(pose(), baseline_m), frame_of(96, 64, 60)) {
    FrameHits hits, hits_of_right;
    truth = truth_of(cast.scene, left, 100, threads, hits);
    of_right = truth_of(cast.scene, right, 100, threads, hits_of_right);
    stereo = stereo_truth(left, truth, hits, baseline_m, cast.caster, threads);
  }
  static Pose pose() {
    Pose pose = looking({0, 0, 0}, {5, 0.4, 0.7});
    pose.velocity_m_s = {1, 0, 0};
    pose.turning_rad_s = {0, 0, 0.2};
    return pose;
  }
};

// A pile before a wall, so that each camera sees what the other does not.
const Cast& pile_before_a_wall() {
  static const Cast cast({wall_mesh(9), cylinder_mesh({4, 0.3, -6}, 0.5, 12, 48, 4)});
  return cast;
}

TEST(Stereo, DisparityIsFocalLengthTimesBaselineOverDepth) {
  const Pair pair(pile_before_a_wall());
  const double focal = 48 / std::tan(30 * constants::degree);
  for (std::size_t at = 0; at < pair.truth.pixels(); ++at)
    EXPECT_NEAR(pair.stereo.disparity[at], focal * baseline_m / pair.truth.depth_m[at],
                1e-5 * pair.stereo.disparity[at]);
}

// The same by projection: the place falls so many pixels farther left, and in the same row.
TEST(Stereo, APlaceLiesThatFarApartInBothPictures) {
  const Pair pair(pile_before_a_wall());
  for (int j = 0; j < 64; ++j)
    for (int i = 0; i < 96; ++i) {
      const auto at = static_cast<std::size_t>(j * 96 + i);
      const Ray ray = pair.left.ray(i, j);
      const double range_m = static_cast<double>(pair.truth.range_m[at]);
      const auto place = pair.right.place_of(ray.from_m + range_m * ray.direction);
      ASSERT_TRUE(place);
      EXPECT_NEAR(i + 0.5 - place->u, pair.stereo.disparity[at], 1e-4);
      EXPECT_NEAR(place->v, j + 0.5, 1e-5);
    }
}

// What is in both is what the right picture's own pixel shows there: within what a pixel's width
// of the surface makes of its depth. What is not there is hidden by something nearer, or outside.
TEST(Stereo, WhatIsInBothIsInTheRightPicture) {
  const Pair pair(pile_before_a_wall());
  std::size_t both = 0, hidden = 0, outside = 0;
  for (int j = 0; j < 64; ++j)
    for (int i = 0; i < 96; ++i) {
      const auto at = static_cast<std::size_t>(j * 96 + i);
      const double u = i + 0.5 - static_cast<double>(pair.stereo.disparity[at]);
      if (u < 0) {
        EXPECT_EQ(pair.stereo.is_in_both[at], 0);
        ++outside;
        continue;
      }
      // Pixels whose neighbours show another thing are half of either.
      const int k = static_cast<int>(u);
      const auto instance = [&](int column) {
        const int held = std::clamp(column, 0, 95);
        return pair.of_right.instance[static_cast<std::size_t>(j * 96 + held)];
      };
      if (instance(k - 1) != instance(k) || instance(k + 1) != instance(k)) continue;
      const bool is_same = instance(k) == pair.truth.instance[at];
      EXPECT_EQ(pair.stereo.is_in_both[at] == 1, is_same) << i << " " << j;
      both += is_same ? 1 : 0;
      hidden += is_same ? 0 : 1;
    }
  EXPECT_GT(both, 4000U);
  EXPECT_GT(hidden, 50U) << "of the wall, by the pile";
  EXPECT_GT(outside, 100U);
}

TEST(Stereo, TheRightCameraGoesAsItsPlaceOnTheHullGoes) {
  const Pose left = Pair::pose(), right = right_of(left, baseline_m);
  EXPECT_NEAR(length_of(right.position_m - left.position_m), baseline_m, 1e-12);
  EXPECT_NEAR(dot(right.position_m - left.position_m, left.axis), 0, 1e-12);
  const Triple<double> expected =
      left.velocity_m_s + cross(left.turning_rad_s, right.position_m - left.position_m);
  EXPECT_EQ(length_of(right.velocity_m_s - expected), 0);
}

TEST(Stereo, IsTheSameOnAnyNumberOfThreads) {
  const Pair one(pile_before_a_wall(), 1), two(pile_before_a_wall(), 2);
  EXPECT_EQ(one.stereo.disparity, two.stereo.disparity);
  EXPECT_EQ(one.stereo.is_in_both, two.stereo.is_in_both);
}

}  // namespace
}  // namespace slackwater::twin::stereo_test
