#include "twin/inspection/instrument/quality.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"
#include "tests/twin/inspection/meshes_for_tests.h"
#include "twin/inspection/instrument/pose.h"

namespace slackwater::twin::quality_test {
namespace {

constexpr double degree = constants::pi / 180;

/// 4000 x 3000 pixels of one size, 60 degrees wide, 1/500 s.
Instrument camera() {
  Instrument made;
  made.kind = InstrumentKind::rgb;
  const double vertical = 2 * std::atan(std::tan(30 * degree) * 0.75);
  made.footprint = FrameFootprint{60 * degree, vertical, 4000, 3000, 1.0 / 500};
  made.least_range_m = 0.1;
  made.most_range_m = 100;
  return made;
}
Instrument fan(double pings_per_s) {
  Instrument made;
  made.kind = InstrumentKind::multibeam;
  made.footprint = FanFootprint{120 * degree, 0, 0.5 * degree, 1 * degree, pings_per_s};
  made.most_range_m = 100;
  return made;
}

/// At the origin, looking north.
Pose ahead() { return {{}, {1, 0, 0}, {0, 1, 0}, {}, {}}; }
const Triple<double> south{-1, 0, 0};

/// A face turned away by an angle, about the vertical.
Triple<double> turned(double angle_rad) { return {-std::cos(angle_rad), std::sin(angle_rad), 0}; }

TEST(LookQuality, APixelIsAsLargeAsBySchoolGeometry) {
  const auto q = quality_of(camera(), ahead(), {}, {10, 0, 0}, south);
  ASSERT_TRUE(q);
  EXPECT_NEAR(q->ground_sampling_m, 2 * 10 * std::tan(30 * degree) / 4000, 1e-15);
  EXPECT_NEAR(q->ground_sampling_m, 0.00289, 5e-6);
  EXPECT_EQ(q->incidence_cosine, 1);
  EXPECT_EQ(q->blur_m, 0);
  EXPECT_EQ(q->detail_m, q->ground_sampling_m);
}

TEST(LookQuality, APixelGrowsByTheCosineOfTheIncidence) {
  for (const double angle : {10.0, 45.0, 70.0}) {
    const auto q = quality_of(camera(), ahead(), {}, {10, 0, 0}, turned(angle * degree));
    ASSERT_TRUE(q);
    EXPECT_NEAR(q->incidence_cosine, std::cos(angle * degree), 1e-15);
    EXPECT_NEAR(q->ground_sampling_m, 0.0028867513459 / std::cos(angle * degree), 1e-12);
  }
}

// A picture of a plane that is parallel to it has one scale.
TEST(LookQuality, AParallelPlaneHasOneScale) {
  for (const double aside_m : {-5.0, -1.0, 0.0, 3.0, 5.7}) {
    const auto q = quality_of(camera(), ahead(), {}, {10, aside_m, 0.4 * aside_m}, south);
    ASSERT_TRUE(q);
    EXPECT_NEAR(q->ground_sampling_m, 0.0028867513459, 1e-12);
  }
}

// The pixel's sides on the surface by finite differences: the rays through its edges, met with the
// plane.
TEST(LookQuality, APixelAnywhereIsWhatItsRaysEnclose) {
  Rng rng(8, "test/quality");
  const double f = 4000 / (2 * std::tan(30 * degree));
  for (int i = 0; i < 200; ++i) {
    const Triple<double> at{rng.uniform(5, 20), rng.uniform(-2, 2), rng.uniform(-2, 2)};
    const Triple<double> normal = unit({-1, rng.uniform(-1, 1), rng.uniform(-1, 1)});
    const auto q = quality_of(camera(), ahead(), {}, at, normal);
    ASSERT_TRUE(q);
    const auto met = [&](double u, double v) {
      const Triple<double> way{1, u / f, v / f};
      return (dot(normal, at) / dot(normal, way)) * way;
    };
    const double u = f * at.y / at.x, v = f * at.z / at.x;
    const double wide = length_of(met(u + 0.5, v) - met(u - 0.5, v));
    const double high = length_of(met(u, v + 0.5) - met(u, v - 0.5));
    EXPECT_NEAR(q->ground_sampling_m, std::max(wide, high), 1e-5 * q->ground_sampling_m);
  }
}

TEST(LookQuality, MotionSmearsByWhatRunsOverTheSurface) {
  Pose pose = ahead();
  pose.velocity_m_s = {0, 1, 0};
  EXPECT_NEAR(quality_of(camera(), pose, {}, {10, 0, 0}, south)->blur_m, 0.002, 1e-15);
  pose.velocity_m_s = {1, 0, 0};
  EXPECT_NEAR(quality_of(camera(), pose, {}, {10, 0, 0}, south)->blur_m, 0, 1e-15) << "approach";
  EXPECT_NEAR(quality_of(camera(), pose, {}, {10, 1, 0}, south)->blur_m, 0.0002, 1e-15)
      << "off the axis the picture grows: v x/z";
  pose.velocity_m_s = {0, 1, 0};
  EXPECT_NEAR(quality_of(camera(), pose, {}, {10, 0, 0}, turned(60 * degree))->blur_m, 0.004, 1e-14)
      << "over a face that is turned away: v / cos";
}

TEST(LookQuality, TurningSmearsByTheRange) {
  Pose pose = ahead();
  pose.turning_rad_s = {0, 0, 0.1};
  EXPECT_NEAR(quality_of(camera(), pose, {}, {10, 0, 0}, south)->blur_m, 0.1 * 10 / 500, 1e-15);
  // Who circles what he looks at does not smear it.
  pose.velocity_m_s = {0, -1, 0};
  EXPECT_NEAR(quality_of(camera(), pose, {}, {10, 0, 0}, south)->blur_m, 0, 1e-15);
}

TEST(LookQuality, DetailIsSamplingAndBlurOverContrastAndLight) {
  Pose pose = ahead();
  pose.velocity_m_s = {0, 1, 0};
  Instrument dim = camera();
  dim.needs_light = true;
  const Clarity clarity{0.1, 0.5, 0};
  const auto q = quality_of(dim, pose, clarity, {10, 0, 0}, south);
  ASSERT_TRUE(q);
  EXPECT_NEAR(q->contrast, std::exp(-1.0), 1e-15);
  EXPECT_EQ(q->light, 0.5);
  EXPECT_NEAR(q->detail_m, std::hypot(q->ground_sampling_m, 0.002) / (std::exp(-1.0) * 0.5), 1e-15);
}

TEST(LookQuality, LightIsOfTheDayOrOfTheLamp) {
  Instrument lamp = camera();
  lamp.needs_light = true;
  const Clarity day{0, 1, 0.2};
  const auto light_at = [&](double depth_m, double range_m, const Clarity& clarity) {
    Pose pose = ahead();
    pose.position_m.z = depth_m;
    const auto q = quality_of(lamp, pose, clarity, {range_m, 0, depth_m}, south);
    return q ? q->light : 0;
  };
  EXPECT_EQ(light_at(-20, 5, day), 1) << "in the air";
  EXPECT_NEAR(light_at(10, 5, day), std::exp(-2.0), 1e-15);
  const Clarity night{0, 0, 0.2};
  EXPECT_EQ(light_at(10, 5, night), 0) << "nothing is seen in the dark";
  lamp.lamp_range_m = 2;
  lamp.lamp_aside_m = 0;
  EXPECT_NEAR(light_at(10, 5, night), 4.0 / 25, 1e-15);
  EXPECT_EQ(light_at(10, 1, night), 1);
  EXPECT_NEAR(light_at(10, 5, day), std::exp(-2.0) + 4.0 / 25, 1e-15);
}

TEST(LookQuality, SoundGoesThroughMurk) {
  const auto q = quality_of(fan(1e6), ahead(), {3, 0, 1}, {10, 0, 0}, south);
  ASSERT_TRUE(q);
  EXPECT_EQ(q->contrast, 1);
  EXPECT_EQ(q->light, 1);
}

TEST(LookQuality, ABeamIsItsAngleTimesTheRangeOrTheWayBetweenPings) {
  Pose pose = ahead();  // across: east; along the track: down
  pose.velocity_m_s = {0, 0, 2};
  EXPECT_NEAR(quality_of(fan(1e6), pose, {}, {10, 0, 0}, south)->ground_sampling_m, 10 * degree,
              1e-12);
  EXPECT_NEAR(quality_of(fan(5), pose, {}, {10, 0, 0}, south)->ground_sampling_m, 0.4, 1e-12);
  // 60 degrees off a flat bed: r = 20 m, and the beam across lies 1 / cos flat.
  const auto edge = quality_of(fan(1e6), pose, {}, {10, 10 * std::tan(60 * degree), 0}, south);
  ASSERT_TRUE(edge);
  EXPECT_NEAR(edge->range_m, 20, 1e-12);
  EXPECT_NEAR(edge->ground_sampling_m, 20 * 1 * degree, 1e-12) << "across: 20 x 0.5 deg / cos 60";
}

TEST(LookQuality, NothingIsMeasuredOutOfRangeOrFromBehind) {
  EXPECT_FALSE(quality_of(camera(), ahead(), {}, {101, 0, 0}, south));
  EXPECT_FALSE(quality_of(camera(), ahead(), {}, {0.05, 0, 0}, south));
  EXPECT_FALSE(quality_of(camera(), ahead(), {}, {10, 0, 0}, {1, 0, 0}));
  EXPECT_FALSE(quality_of(camera(), ahead(), {}, {10, 0, 0}, {0, 1, 0})) << "edge-on";
  EXPECT_FALSE(quality_of(camera(), ahead(), {}, {0, 0, 0}, south));
}

Rotation<double> heading(double degrees, double pitch_degrees = 0) {
  return rotation_of(attitude_of({0, pitch_degrees * degree, degrees * degree}));
}
void expect_near(const Triple<double>& found, const Triple<double>& expected) {
  EXPECT_NEAR(length_of(found - expected), 0, 1e-12) << found.x << " " << found.y << " " << found.z;
}

TEST(PoseOf, AFixedOneGoesWithTheHull) {
  Instrument down = camera();
  down.axis = {0, 0, 1};
  down.position_m = {2, 0, 1};
  const Pose pose = pose_of(down, {{10, 20, 5}, heading(90), {1, 0, 0}, {0, 0, 0.5}}, {});
  expect_near(pose.position_m, {10, 22, 6});
  expect_near(pose.axis, {0, 0, 1});
  expect_near(pose.right, {-1, 0, 0});        // starboard of one that heads east is south
  expect_near(pose.velocity_m_s, {0, 0, 0});  // 0.5 rad/s on 2 m takes 1 m/s off
  expect_near(pose.turning_rad_s, {0, 0, 0.5});
  Instrument starboard = camera();
  starboard.axis = {0, 1, 0};
  expect_near(pose_of(starboard, {{}, heading(0), {}, {}}, {}).right, {-1, 0, 0});
  expect_near(pose_of(camera(), {{}, heading(0), {}, {}}, {}).right, {0, 1, 0});
}

TEST(PoseOf, AFixedFanStandsAcrossTheHull) {
  Instrument sonar = fan(10);
  sonar.axis = {0, 0, 1};
  for (const double degrees : {0.0, 30.0, 200.0}) {
    const Rotation<double> r = heading(degrees, 10);
    const Pose pose = pose_of(sonar, {{}, r, {}, {}}, {});
    expect_near(cross(pose.right, pose.axis), r.to_ned({1, 0, 0}));
  }
}

TEST(PoseOf, OneTurnedToTheSurfaceStaysUpright) {
  Instrument gimbal = camera();
  gimbal.aim = Aim::surface;
  const Carriage carriage{{0, 0, -20}, heading(0), {0, 2, 0}, {0.1, 0.2, 0.3}};
  const Pose pose = pose_of(gimbal, carriage, {{0, 10, -20}, {}});
  expect_near(pose.axis, {0, 1, 0});
  expect_near(pose.right, {-1, 0, 0});
  expect_near(pose.turning_rad_s, {});
  const Pose down = pose_of(gimbal, carriage, {});
  expect_near(down.axis, {0, 0, 1});
  expect_near(down.right, {0, 1, 0});
  Instrument sonar = fan(10);
  sonar.aim = Aim::surface;
  const Pose swept = pose_of(sonar, {{}, heading(0), {0, 0, 1}, {}}, {{10, 0, 0}, {}});
  EXPECT_NEAR(std::abs(swept.right.y), 1, 1e-12) << "a fan that goes down lies level";
}

TEST(StepBetweenLooks, IsHalfOfTheFootprint) {
  EXPECT_NEAR(step_between_looks_m(camera(), 10), 10 * 0.75 * std::tan(30 * degree), 1e-12);
  Instrument spot;
  spot.footprint = SpotFootprint{0.02, 1};
  EXPECT_EQ(step_between_looks_m(spot, 0.1), 0.01);
  EXPECT_NEAR(step_between_looks_m(fan(5), 10), 10 * std::tan(45 * degree) / 2, 1e-12);
}

}  // namespace
}  // namespace slackwater::twin::quality_test
