// Coverage against what geometry says: a pile that is circled, a bed that is gone over in parallel
// lines by a vehicle that drifts, a blade that is orbited.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/twin/inspection/inspection_for_tests.h"

namespace slackwater::twin::coverage_test {
namespace {

using namespace slackwater::twin::tests;

constexpr double turn = 2 * constants::pi;

/// Ahead, wide and high as asked, and as sharp as one likes.
std::string camera(double horizontal_deg, double vertical_deg) {
  return "kind: rgb\nrange_m: [0.1, 200]\naim: {axis: [1, 0, 0]}\nframe: {horizontal_deg: " +
         std::to_string(horizontal_deg) + ", vertical_deg: " + std::to_string(vertical_deg) +
         ", pixels_wide: 4000, pixels_high: 3000, exposure_s: 0.0001}\n";
}

/// On a circle about the origin's axis, its bow to it.
Carriage circling(double radius_m, double down_m, double bearing_rad) {
  return level({radius_m * std::cos(bearing_rad), radius_m * std::sin(bearing_rad), down_m},
               bearing_rad + constants::pi);
}

TEST(Coverage, OfAPileThatACameraCirclesIsTheBandThatItsFrameHolds) {
  const InspectionFolder folder;
  folder.add("camera", camera(6, 60));
  const double radius_m = 3, off_m = 10, deep_m = 15;
  const auto inspection = folder.made(
      "surfaces: [{kind: monopile, north_m: 0, east_m: 0, radius_m: 3, from: {depth_m: 0}, to: "
      "{depth_m: 30}, patch_m: 0.1}]\n"
      "looks: [{instrument: camera, kinds: [monopile], detail_mm: 100}]\n",
      {{{13, 0, 15}, 1}});
  const InspectionState state = inspected_along(*inspection, 315, 1, [&](std::size_t i) {
    return circling(radius_m + off_m, deep_m, turn * static_cast<double>(i) / 314);
  });
  // A place at an angle a off the bow lies R sin a aside and d + R (1 - cos a) ahead: the farther
  // aside the frame holds it, the higher.
  double aside_rad = 0;
  while (radius_m * std::sin(aside_rad) <=
         (off_m + radius_m * (1 - std::cos(aside_rad))) * std::tan(3 * degree))
    aside_rad += 1e-5;
  const double half_m = (off_m + radius_m * (1 - std::cos(aside_rad))) * std::tan(30 * degree);
  EXPECT_NEAR(covered_share(*inspection, state), 2 * half_m / 30, 0.01 * 2 * half_m / 30);
}

/// Along two lines, 10 m either side of a cable that lies north, with the bow off the way.
double covered_strip(double drift_rad) {
  const InspectionFolder folder;
  folder.add("multibeam",
             "kind: multibeam\nrange_m: [0.5, 100]\naim: {axis: [0, 0, 1]}\nfan: {across_deg: 120, "
             "beam_across_deg: 0.5, beam_along_deg: 1, pings_per_s: 20}\n");
  const auto inspection = folder.made(
      "surfaces: [{kind: cable, route: [{north_m: 0, east_m: 0, depth_m: 30}, {north_m: 100, "
      "east_m: 0, depth_m: 30}], burial_m: 1, corridor_m: 40, off_ends_m: 0, patch_m: 0.2}]\n"
      "looks: [{instrument: multibeam, kinds: [cable], detail_mm: 5000}]\n",
      {{{50, 0, 24}, 1}});
  InspectionState state = begin_inspection(*inspection, 1);
  double t_s = 0;
  for (const double east_m : {-10.0, 10.0}) {
    for (double north_m = -20; north_m <= 120; north_m += 0.5, t_s += 0.5) {
      const Carriage carriage = level({north_m, east_m, 24}, drift_rad, {1, 0, 0});
      inspect(*inspection, true, carriage, carriage.position_m, t_s, 0.5, state);
    }
    inspect(*inspection, false, {}, {}, t_s, 0.5, state);  // on its way to the next line
  }
  return covered_share(*inspection, state);
}

TEST(Coverage, OfABedInParallelLinesIsThatOfTheirSwaths) {
  // 2 h tan 60 = 20.8 m from each, 20 m apart: all of the 40 m.
  EXPECT_NEAR(covered_strip(0), 1, 1e-3);
  // In a cross current the fan lies askew, and its swath shrinks with the cosine: 18 m of each 20.
  const double swath_m = 12 * std::tan(60 * degree) * std::cos(30 * degree);
  EXPECT_NEAR(covered_strip(30 * degree), 2 * swath_m / 40, 0.01 * 2 * swath_m / 40);
}

TEST(Coverage, OfABladeByAnOrbitIsWhatFacesTheOrbitWithinItsFrames) {
  const InspectionFolder folder;
  folder.add("camera", camera(12, 40));
  const auto inspection = folder.made(
      "surfaces: [{kind: blade, north_m: 0, east_m: 0, height_m: 60, blade: 1, tip_m: 40, "
      "rotor_faces_deg: 270, overhang_m: 0, root_m: 2, chord_m: 2, tip_chord_m: 2, "
      "root_thickness: 0.24, tip_thickness: 0.24, twist_deg: 0, pitch_deg: 0, camber: 0, patch_m: "
      "0.1}]\n"
      "looks: [{instrument: camera, kinds: [blade], detail_mm: 100}]\n",
      {{{15, 0, -80}, 1}});
  const double orbit_m = 15, down_m = -80;
  constexpr int steps = 360;
  const InspectionState state = inspected_along(*inspection, steps + 1, 1, [&](std::size_t i) {
    return circling(orbit_m, down_m, turn * static_cast<double>(i) / steps);
  });
  // Of a section that bulges outward all over, what faces an eye is seen.
  double seen_m2 = 0, all_m2 = 0;
  for (const Patch& patch : inspection->surfaces.front().patches) {
    all_m2 += patch.area_m2;
    bool is_seen = false;
    for (int i = 0; i < steps && !is_seen; ++i) {
      const double b = turn * i / steps;
      const Triple<double> eye_m{orbit_m * std::cos(b), orbit_m * std::sin(b), down_m};
      const Triple<double> way_m = patch.centre_m - eye_m;
      const double ahead_m = -(way_m.x * std::cos(b) + way_m.y * std::sin(b));
      const double aside_m = way_m.y * std::cos(b) - way_m.x * std::sin(b);
      is_seen = dot(way_m, patch.normal) < 0 &&
                std::abs(aside_m) <= ahead_m * std::tan(6 * degree) &&
                std::abs(way_m.z) <= ahead_m * std::tan(20 * degree);
    }
    if (is_seen) seen_m2 += patch.area_m2;
  }
  ASSERT_GT(seen_m2, 0.2 * all_m2);
  EXPECT_NEAR(covered_share(*inspection, state), seen_m2 / all_m2, 0.01 * seen_m2 / all_m2);
  // And as a whole: both faces over the height of the frame, 2 d tan 20, of the span.
  EXPECT_NEAR(covered_share(*inspection, state), 2 * 15 * std::tan(20 * degree) / 38, 0.03);
}

TEST(Coverage, WithEightyRaysALookIsThatOfTwoThousandWithinTwoPoints) {
  const InspectionFolder folder;
  folder.add("camera", camera(60, 45));
  const auto share = [&](std::size_t rays) {
    const auto inspection = folder.made(
        "surfaces: [{kind: monopile, north_m: 0, east_m: 0, radius_m: 3, from: {depth_m: 0}, to: "
        "{depth_m: 30}}]\n"
        "looks: [{instrument: camera, kinds: [monopile], detail_mm: 100, incidence_deg: 50}]\n",
        {{{6, 0, 15}, 1}}, rays);
    const InspectionState state = inspected_along(*inspection, 630, 1, [&](std::size_t i) {
      const double round = static_cast<double>(i) / 210;
      return circling(6, 5 + 7 * round, turn * round);
    });
    return covered_share(*inspection, state);
  };
  const double few = share(80), many = share(2000);
  EXPECT_GT(many, 0.3);
  EXPECT_LT(many, 0.9);
  EXPECT_NEAR(few, many, 0.02);
}

TEST(Coverage, IsNoneOfWhatIsPassedWhenNotAtWork) {
  const InspectionFolder folder;
  folder.add("camera", camera(60, 60));
  const auto inspection = folder.made(
      "surfaces: [{kind: monopile, north_m: 0, east_m: 0, radius_m: 3, from: {depth_m: 0}, to: "
      "{depth_m: 30}, patch_m: 0.5}]\n"
      "looks: [{instrument: camera, kinds: [monopile], detail_mm: 100}]\n",
      {{{13, 0, 15}, 1}});
  InspectionState state = begin_inspection(*inspection, 1);
  for (int i = 0; i < 100; ++i)
    inspect(*inspection, false, circling(13, 15, 0.1 * i), {}, i, 1, state);
  EXPECT_EQ(covered_share(*inspection, state), 0);
  EXPECT_EQ(state.rays, 0U);
}

}  // namespace
}  // namespace slackwater::twin::coverage_test
