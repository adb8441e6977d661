#include "twin/render/light/mark_share.h"

#include <gtest/gtest.h>

#include "tests/twin/render/render_for_tests.h"

namespace slackwater::twin::mark_share_test {
namespace {

/// On the plane z = 2 about its origin, its long side `turn` from north.
DefectMark mark_with(DefectKind kind, double long_m, double wide_m, double turn_rad) {
  DefectMark mark;
  mark.kind = kind;
  mark.centre_m = {0, 0, 2};
  mark.normal = {0, 0, -1};
  mark.along = {std::cos(turn_rad), std::sin(turn_rad), 0};
  mark.down = cross(mark.normal, mark.along);
  mark.half_along_m = 0.5 * long_m;
  mark.half_down_m = 0.5 * wide_m;
  return mark;
}

Triple<double> met_on_plane(const Pinhole& camera, int i, int j) {
  const Ray ray = camera.ray(i, j);
  return ray.from_m + ((2 - ray.from_m.z) / ray.direction.z) * ray.direction;
}

/// Over all pixels: of each, its footprint's area times its share.
double covered_m2(const Pinhole& camera, const DefectMark& mark) {
  double sum = 0;
  for (int j = 0; j < camera.high(); ++j)
    for (int i = 0; i < camera.wide(); ++i) {
      const PixelFootprint pixel(camera, met_on_plane(camera, i, j), {0, 0, -1});
      sum += share_of(mark, pixel) * length_of(cross(pixel.side_m, pixel.down_m));
    }
  return sum;
}

TEST(MarkShare, CoversAsMuchAsTheMarkIsLarge) {
  const FrameFootprint frame = frame_of(160, 90, 64);  // pixels of 16 mm at 2 m
  const Pinhole square(looking({0, 0, 0}, {0, 0, 2}), frame);
  const Pinhole askew(looking({0.9, 0.5, 0.6}, {0, 0, 2}), frame);
  for (const Pinhole* camera : {&square, &askew})
    for (const double turn : {0.1, 0.8, 1.5}) {
      const DefectMark crack = mark_with(DefectKind::crack, 0.6, 0.006, turn);
      EXPECT_NEAR(covered_m2(*camera, crack), 0.6 * 0.006, 0.06 * 0.6 * 0.006) << turn;
      const DefectMark rust = mark_with(DefectKind::corrosion, 0.4, 0.25, turn);
      const double ellipse_m2 = 3.14159265 / 4 * 0.4 * 0.25;
      EXPECT_NEAR(covered_m2(*camera, rust), ellipse_m2, 0.005 * ellipse_m2) << turn;
    }
}

TEST(MarkShare, IsWholeWithinAndNoneBeyond) {
  const Pinhole camera(looking({0, 0, 0}, {0, 0, 2}), frame_of(160, 90, 64));
  const DefectMark rust = mark_with(DefectKind::corrosion, 0.4, 0.25, 0.3);
  const auto share_at = [&](int i, int j) {
    return share_of(rust, PixelFootprint(camera, met_on_plane(camera, i, j), {0, 0, -1}));
  };
  EXPECT_EQ(share_at(80, 45), 1);
  EXPECT_EQ(share_at(0, 0), 0);
}

TEST(MarkShare, OfACrackThinnerThanAPixelIsItsWidthOfThatPixel) {
  const Pinhole camera(looking({0, 0, 0}, {0, 0, 2}), frame_of(160, 90, 64));
  const double pixel_m = 2 / camera.focal_u();
  // Along a column of pixels, in its middle.
  const Triple<double> at_m = met_on_plane(camera, 80, 45);
  const PixelFootprint pixel(camera, at_m, {0, 0, -1});
  DefectMark crack = mark_with(DefectKind::crack, 0.6, 0.25 * pixel_m, 0);
  crack.along = (1 / length_of(pixel.down_m)) * pixel.down_m;
  crack.down = cross(crack.normal, crack.along);
  crack.centre_m = at_m;
  EXPECT_DOUBLE_EQ(share_of(crack, pixel), 0.25);
}

TEST(MarkShare, HoldsOnAFaceSeenEdgeOn) {
  const Pinhole camera(looking({0, -5, 2}, {0, 0, 2}), frame_of(160, 90, 64));
  const PixelFootprint pixel(camera, {0, 0, 2}, {0, 0, -1});
  EXPECT_LT(length_of(pixel.down_m), 21 * 5 / camera.focal_v());
  EXPECT_GT(share_of(mark_with(DefectKind::corrosion, 0.4, 0.25, 0.3), pixel), 0);
}

}  // namespace
}  // namespace slackwater::twin::mark_share_test
