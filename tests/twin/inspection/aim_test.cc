// How a camera that is kept on the nearest place turns, and what that leaves of its blur: against
// pictures taken one after the other.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"
#include "tests/twin/inspection/inspection_for_tests.h"
#include "tests/twin/inspection/meshes_for_tests.h"
#include "twin/inspection/instrument/bend.h"
#include "twin/inspection/instrument/pose.h"
#include "twin/inspection/instrument/quality.h"
#include "twin/inspection/surface/make_surface.h"

namespace slackwater::twin::aim_test {
namespace {

using tests::InspectionFolder;

constexpr double exposure_s = 1e-5;  // short: two pictures differ to first order

Instrument camera(Aim aim) {
  Instrument made;
  made.kind = InstrumentKind::rgb;
  made.footprint = FrameFootprint{1.2, 0.9, 4000, 3000, exposure_s};
  made.most_range_m = 1000;
  made.aim = aim;
  return made;
}

constexpr double radius_m = 3;

/// What is nearest of an upright pile about the origin.
AimedAt on_pile(const Triple<double>& from_m) {
  const Triple<double> n = unit({from_m.x, from_m.y, 0});
  return {radius_m * n + Triple<double>{0, 0, from_m.z},
          {n, {-n.y, n.x, 0}, {0, 0, 1}, 1 / radius_m, 0}};
}
/// Of a ball about the origin.
AimedAt on_ball(const Triple<double>& from_m) {
  const Triple<double> n = unit(from_m), across = unit({-n.y, n.x, 0});
  return {radius_m * n, {n, across, cross(n, across), 1 / radius_m, 1 / radius_m}};
}

Carriage carried(const Triple<double>& at_m, const Triple<double>& velocity_m_s,
                 const Triple<double>& rates_rad_s = {}) {
  return {at_m, rotation_of(attitude_of({0.05, -0.1, 0.7})), velocity_m_s, rates_rad_s};
}

/// Where a place is in a picture: to the right and down of its middle, by the depth along the axis.
struct InPicture {
  double x = 0;
  double y = 0;
};
InPicture projected(const Pose& pose, const Triple<double>& place_m) {
  const Triple<double> way = place_m - pose.position_m;
  const double depth = dot(way, pose.axis);
  return {dot(way, pose.right) / depth, dot(way, cross(pose.axis, pose.right)) / depth};
}

/// How far over the plane through a place its picture moves from one pose to the next: where the
/// second picture's ray to the place meets the plane when it is laid in the first.
double smeared_m(const Pose& first, const Pose& second, const Triple<double>& place_m,
                 const Triple<double>& normal) {
  const InPicture at = projected(second, place_m);
  const Triple<double> ray =
      first.axis + at.x * first.right + at.y * cross(first.axis, first.right);
  const Triple<double> met_m =
      first.position_m + (dot(normal, place_m - first.position_m) / dot(normal, ray)) * ray;
  return length_of(met_m - place_m);
}

using Nearest = AimedAt(const Triple<double>&);

/// A look by the gimbal at a place beside the nearest one, and two pictures about that time.
void expect_smear_of_two_pictures(Nearest& nearest, const Triple<double>& at_m, Rng& rng) {
  const Instrument gimbal = camera(Aim::surface);
  const Triple<double> v{rng.normal(), rng.normal(), rng.normal()};
  const auto pose_at = [&](double t_s) {
    const Triple<double> there_m = at_m + t_s * v;
    return pose_of(gimbal, carried(there_m, v, {0.3, -0.2, 0.4}), nearest(there_m));
  };
  const Pose pose = pose_at(0);
  const Triple<double> aside_m{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
  const AimedAt beside = nearest(at_m + aside_m);
  const Triple<double>&place_m = beside.place_m, &normal = beside.bend.normal;
  const auto quality = quality_of(gimbal, pose, {}, place_m, normal);
  ASSERT_TRUE(quality);
  const double between = 0.5 * exposure_s;
  const double smear_m = smeared_m(pose_at(-between), pose_at(between), place_m, normal);
  EXPECT_NEAR(quality->blur_m, smear_m, 2e-6 * exposure_s + 1e-4 * smear_m);
}

TEST(AimedCamera, SmearsByWhatTwoPicturesDifferBy) {
  Rng rng(3, "test/aim");
  for (int i = 0; i < 300; ++i) {
    const double bearing = rng.uniform(0, 6.28), off_m = rng.uniform(4.5, 12);
    const Triple<double> level_m{off_m * std::cos(bearing), off_m * std::sin(bearing), 0};
    expect_smear_of_two_pictures(on_pile, level_m + Triple<double>{0, 0, rng.uniform(-20, 20)},
                                 rng);
    expect_smear_of_two_pictures(on_ball, level_m + Triple<double>{0, 0, rng.uniform(-3, 3)}, rng);
  }
}

// Of a camera that is fixed to a hull that turns, by the same two pictures.
TEST(FixedCamera, SmearsByWhatTwoPicturesDifferBy) {
  Instrument fixed = camera(Aim::fixed);
  fixed.position_m = {0.4, 0.1, 0.2};
  Rng rng(4, "test/aim");
  for (int i = 0; i < 300; ++i) {
    const Triple<double> v{rng.normal(), rng.normal(), rng.normal()};
    const double yaw_rad_s = 0.5 * rng.normal();
    const auto pose_at = [&](double t_s) {
      return pose_of(
          fixed, {t_s * v, rotation_of(attitude_of({0, 0, yaw_rad_s * t_s})), v, {0, 0, yaw_rad_s}},
          {});
    };
    const Triple<double> place_m{rng.uniform(3, 9), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    const Triple<double> normal = unit({-1, rng.uniform(-0.5, 0.5), rng.uniform(-0.5, 0.5)});
    const auto quality = quality_of(fixed, pose_at(0), {}, place_m, normal);
    ASSERT_TRUE(quality);
    const double between = 0.5 * exposure_s;
    const double smear_m = smeared_m(pose_at(-between), pose_at(between), place_m, normal);
    EXPECT_NEAR(quality->blur_m, smear_m, 2e-6 * exposure_s + 1e-4 * smear_m);
  }
}

// Longuet-Higgins & Prazdny (1980), Proc. R. Soc. B 208, equation 2.7: with x, y in the picture, Z
// along the axis, the camera's velocity U, V, W and turning A, B, C about x, y, z.
TEST(AimedCamera, SmearsByTheVelocityOfItsPicture) {
  const Instrument gimbal = camera(Aim::surface);
  Rng rng(5, "test/aim");
  for (int i = 0; i < 100; ++i) {
    const Triple<double> at_m{rng.uniform(5, 9), 0, 0};
    const Triple<double> v{rng.normal(), rng.normal(), rng.normal()};
    const Pose pose = pose_of(gimbal, carried(at_m, v), on_pile(at_m));
    const Triple<double> down = cross(pose.axis, pose.right);
    const double x = rng.uniform(-0.3, 0.3), y = rng.uniform(-0.3, 0.3), depth_m = 4;
    const double u = dot(v, pose.right), w = dot(v, pose.axis), vv = dot(v, down);
    const double a = dot(pose.turning_rad_s, pose.right), b = dot(pose.turning_rad_s, down);
    const double c = dot(pose.turning_rad_s, pose.axis);
    const double x_dot = (-u + x * w) / depth_m + a * x * y - b * (x * x + 1) + c * y;
    const double y_dot = (-vv + y * w) / depth_m + a * (y * y + 1) - b * x * y - c * x;
    // On a plane across the axis what moves by x in the picture moves by Z x.
    const Triple<double> place_m = at_m + depth_m * (pose.axis + x * pose.right + y * down);
    const auto quality = quality_of(gimbal, pose, {}, place_m, -1.0 * pose.axis);
    ASSERT_TRUE(quality);
    EXPECT_NEAR(quality->blur_m, exposure_s * depth_m * std::hypot(x_dot, y_dot), 1e-15);
  }
}

/// Blur in metres a second at a place, of a camera 2 m off that goes at 1 m/s to the east.
double blur_m_s(const AimedAt& target, const Triple<double>& place_m) {
  const Pose pose = pose_of(camera(Aim::surface), carried({2, 0, 0}, {0, 1, 0}), target);
  return quality_of(camera(Aim::surface), pose, {}, place_m, {1, 0, 0})->blur_m / exposure_s;
}

TEST(AimedCamera, SmearsLessAtWhatItIsKeptOnAndMoreAsideOfIt) {
  const Bend wall{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0, 0};
  Bend line = wall, pile = wall;
  line.first_per_m = 1e6;
  pile.first_per_m = 1.0 / 3;
  EXPECT_EQ(blur_m_s({{}, wall}, {}), 1) << "a wall is passed by";
  EXPECT_NEAR(blur_m_s({{}, pile}, {}), 3.0 / 5, 1e-12) << "R / (R + d)";
  EXPECT_NEAR(blur_m_s({{}, line}, {}), 0, 1e-5) << "a thin line is tracked";
  for (const double aside_m : {0.5, 1.0})
    EXPECT_NEAR(blur_m_s({{}, line}, {0, aside_m, 0}), aside_m * aside_m / 4, 1e-5)
        << "and what is beside it runs: x^2 f a second, x the tangent of its angle";
  // From within a pipe that bends more sharply than it is wide nothing is nearest.
  Bend pipe = wall;
  pipe.first_per_m = -1.0 / 2;
  EXPECT_EQ(blur_m_s({{}, pipe}, {}), 1);
}

TEST(AimedCamera, KeepsItsPictureLevelAsItTurns) {
  Rng rng(6, "test/aim");
  for (int i = 0; i < 100; ++i) {
    const Triple<double> v{rng.normal(), rng.normal(), rng.normal()};
    const Triple<double> at_m{5, rng.uniform(-3, 3), rng.uniform(-3, 3)};
    // Also where it looks aside: past the end of what it is to see.
    AimedAt target = on_ball(at_m);
    target.place_m.z += rng.uniform(-2, 2);
    const Pose pose = pose_of(camera(Aim::surface), carried(at_m, v), target);
    EXPECT_NEAR(cross(pose.turning_rad_s, pose.right).z, 0, 1e-12);
    EXPECT_GT(length_of(pose.turning_rad_s), 1e-3);
  }
}

PlannedSurface surface(const std::string& yaml) {
  return read_surface(Config::parse(yaml, "test.yaml"));
}

TEST(BendAt, IsOneOverTheRadiusRoundAPileAndNoneAlongIt) {
  for (const double patch_m : {0.15, 0.5, 1.0}) {
    const Surface pile = make_surface(
        surface("{kind: monopile, north_m: 0, east_m: 0, radius_m: 3, from: {depth_m: 0}, to: "
                "{depth_m: 10}}"),
        patch_m);
    const ViewIndex index = view_index(pile);
    for (std::uint32_t p = 0; p < pile.patches.size(); p += 7) {
      const Bend bend = bend_at(pile, index, p);
      EXPECT_NEAR(bend.first_per_m, 1.0 / 3, 0.02 / 3) << patch_m;
      EXPECT_NEAR(bend.second_per_m, 0, 1e-3);
      EXPECT_NEAR(std::abs(bend.second.z), 1, 1e-4);
      EXPECT_NEAR(dot(bend.first, bend.normal), 0, 1e-12);
    }
  }
}

// Its roof is a parabola across, of 0.3 m over the half of its 6 m.
TEST(BendAt, IsNoneOfAWallAlsoAtItsEdgesAndThatOfARoof) {
  const Surface box = make_surface(
      surface("{kind: nacelle, north_m: 0, east_m: 0, height_m: 90, rotor_faces_deg: 270, width_m: "
              "6, roof_rise_m: 0.3}"),
      0.25);
  const ViewIndex index = view_index(box);
  int walls = 0, ridge = 0;
  for (std::uint32_t p = 0; p < box.patches.size(); ++p) {
    const Bend bend = bend_at(box, index, p);
    if (std::abs(bend.normal.z) < 1e-3) {
      ++walls;
      EXPECT_NEAR(bend.first_per_m, 0, 1e-4);
      EXPECT_NEAR(bend.second_per_m, 0, 1e-4);
    } else if (bend.normal.z < -0.99) {
      ++ridge;
      EXPECT_NEAR(bend.first_per_m, 2 * 0.3 / (3 * 3), 0.002);
      EXPECT_NEAR(bend.second_per_m, 0, 1e-3);
    }
  }
  EXPECT_GT(walls, 100);
  EXPECT_GT(ridge, 20);
}

// All of it in a run: a gimbal that circles a pile at d has R / (R + d) of the blur of a camera
// that slides past.
TEST(AimedCamera, ThatCirclesAPileHasTheBlurOfItsPicture) {
  const InspectionFolder folder;
  folder.add("gimbal",
             "kind: rgb\nrange_m: [0.1, 200]\naim: surface\nframe: {horizontal_deg: 40, "
             "pixels_wide: 4000, pixels_high: 3000, exposure_s: 0.01}\n");
  const auto inspection = folder.made(
      "surfaces: [{kind: monopile, north_m: 0, east_m: 0, radius_m: 3, from: {depth_m: 0}, to: "
      "{depth_m: 10}, patch_m: 0.2}]\n"
      "looks: [{instrument: gimbal, kinds: [monopile], detail_mm: 100}]\n",
      {{{8, 0, 5}, 1}});
  const double speed_m_s = 0.5, off_m = 5;
  const InspectionState state = tests::inspected_along(*inspection, 2000, 0.1, [&](std::size_t i) {
    const double b = speed_m_s * 0.1 * static_cast<double>(i) / (3 + off_m);
    return tests::level({8 * std::cos(b), 8 * std::sin(b), 5}, b + constants::pi,
                        {-speed_m_s * std::sin(b), speed_m_s * std::cos(b), 0});
  });
  const double expected_m = 0.01 * speed_m_s * 3 / 8;
  int seen = 0;
  for (const BestLook& look : state.best.front()) {
    // Those that were met nearly squarely.
    if (!look.is_seen() || look.range_m > 5.05F) continue;
    EXPECT_NEAR(static_cast<double>(look.blur_m), expected_m, 0.06 * expected_m);
    ++seen;
  }
  EXPECT_GT(seen, 100);
}

}  // namespace
}  // namespace slackwater::twin::aim_test
