#include "api/ask/detect/run_finds.h"

#include <gtest/gtest.h>

#include <cmath>

#include "twin/render/frame/pinhole.h"

namespace slackwater::api::run_finds_test {
namespace {

using twin::Triple;

constexpr int wide = 200, high = 100;
constexpr double focal_px = 100;  // 90 degrees across: a pixel is 1/100 of the range

twin::FrameFootprint frame() {
  twin::FrameFootprint out;
  out.pixels_wide = wide;
  out.pixels_high = high;
  out.horizontal_rad = 2 * std::atan(0.5 * wide / focal_px);
  out.vertical_rad = 2 * std::atan(0.5 * high / focal_px);
  return out;
}

/// Looking north at a wall 2 m off, 5 m down; 1 pixel is 20 mm. `east_m`: how far aside it is.
RenderView view_of_wall(double t_s, double east_m) {
  RenderView view;
  view.t_s = t_s;
  view.pose.position_m = {0, east_m, 5};
  view.pose.axis = {1, 0, 0};
  view.pose.right = {0, 1, 0};
  view.things = {{"T1/wall", twin::SeenClass::monopile}};
  CameraView camera;
  camera.picture.wide = camera.truth.wide = wide;
  camera.picture.high = camera.truth.high = high;
  const std::size_t all = std::size_t{wide} * high;
  camera.picture.rgb.resize(3 * all);
  camera.truth.range_m.resize(all);
  const twin::Pinhole pinhole(view.pose, frame());
  for (int j = 0; j < high; ++j)
    for (int i = 0; i < wide; ++i)
      camera.truth.range_m[static_cast<std::size_t>(j * wide + i)] =
          static_cast<float>(2 / pinhole.ray(i, j).direction.x);
  camera.truth.instance.assign(all, 1);
  camera.truth.defect.assign(all, 0);
  camera.truth.normal.assign(all, {0, 0, -1});
  camera.matrix = pinhole.matrix();
  view.seen = std::move(camera);
  return view;
}

/// Rust number 7 of the run, on these pixels.
void plant(RenderView& view, const PixelBox& box) {
  SeenDefect rust;
  rust.number = 7;
  rust.kind = twin::DefectKind::corrosion;
  rust.surface = "T1/wall";
  rust.size_m = 0.4;
  view.defects.push_back(rust);
  auto& defect = std::get<CameraView>(view.seen).truth.defect;
  for (int j = static_cast<int>(box.top); j < static_cast<int>(box.bottom); ++j)
    for (int i = static_cast<int>(box.left); i < static_cast<int>(box.right); ++i)
      defect[static_cast<std::size_t>(j * wide + i)] =
          static_cast<std::uint16_t>(view.defects.size());
}

TEST(RunFinds, TakesAFindToTheWallAndTellsHowLargeItIs) {
  RunFinds finds({"corrosion", "crack"});
  RenderView view = view_of_wall(10, 0);
  plant(view, {140, 40, 160, 50});
  finds.add(view, {{"corrosion", 0.9, {140, 40, 160, 50}}, {"crack", 0.4, {20, 20, 50, 60}}});
  ASSERT_EQ(finds.findings().size(), 2U);
  const RunFinding& rust = finds.findings()[0];
  // The middle of pixel 150, 45 is half a pixel beyond the box's middle.
  EXPECT_NEAR(rust.place_m.x, 2, 1e-6);
  EXPECT_NEAR(rust.place_m.y, 50.5 * 0.02, 1e-6);
  EXPECT_NEAR(rust.place_m.z, 5 - 4.5 * 0.02, 1e-6);
  EXPECT_NEAR(rust.size_m, 20 * 0.02, 1e-6);
  EXPECT_EQ(rust.surface, "T1/wall");
  EXPECT_EQ(rust.defect, 7U);
  EXPECT_NEAR(finds.findings()[1].size_m, 50 * 0.02, 1e-6);  // its diagonal: 30, 40, 50
  EXPECT_FALSE(finds.findings()[1].defect);
  EXPECT_NEAR(finds.pictures()[0].range_m, 2.2, 0.2);
  const auto score = finds.score();
  ASSERT_EQ(score.size(), 2U);
  EXPECT_EQ(score[0].in_view, 1U);
  EXPECT_EQ(score[0].found, 1U);
  EXPECT_EQ(score[0].false_alarms, 0U);
  EXPECT_EQ(score[1].in_view, 0U);
  EXPECT_EQ(score[1].false_alarms, 1U);
}

TEST(RunFinds, SeesOneThingInTwoPicturesAsOneFinding) {
  RunFinds finds({"corrosion"});
  RenderView before = view_of_wall(10, 0), after = view_of_wall(12, 0.2);
  plant(before, {140, 40, 160, 50});
  plant(after, {130, 40, 150, 50});  // 0.2 m: ten pixels
  finds.add(before, {{"corrosion", 0.6, {140, 40, 160, 50}}});
  finds.add(after, {{"corrosion", 0.8, {130, 40, 150, 50}}, {"corrosion", 0.5, {20, 10, 30, 20}}});
  ASSERT_EQ(finds.findings().size(), 2U);
  EXPECT_EQ(finds.findings()[0].pictures, 2U);
  EXPECT_EQ(finds.findings()[0].picture, 1U);
  EXPECT_EQ(finds.findings()[0].confidence, 0.8);
  EXPECT_EQ(finds.findings()[1].pictures, 1U);
  EXPECT_EQ(finds.score()[0].false_alarms, 1U);
}

TEST(RunFinds, CountsWhatIsInViewAndNotFound) {
  RunFinds finds({"corrosion"});
  RenderView view = view_of_wall(0, 0);
  plant(view, {140, 40, 160, 50});
  finds.add(view, {});
  EXPECT_EQ(finds.score()[0].in_view, 1U);
  EXPECT_EQ(finds.score()[0].found, 0U);
  // Beside it, by less than a fifth: no hit.
  finds.add(view, {{"corrosion", 0.7, {157, 40, 177, 50}}});
  EXPECT_EQ(finds.score()[0].found, 0U);
  EXPECT_EQ(finds.score()[0].false_alarms, 1U);
}

TEST(RunFinds, LeavesOutWhatIsTooSmallAndWhatMeetsNothing) {
  RunFinds finds({"corrosion"});
  RenderView view = view_of_wall(0, 0);
  plant(view, {140, 40, 144, 44});
  auto& truth = std::get<CameraView>(view.seen).truth;
  truth.instance.assign(truth.instance.size(), 0);
  finds.add(view, {{"corrosion", 0.7, {140, 40, 144, 44}}});
  EXPECT_EQ(finds.score()[0].in_view, 0U);
  EXPECT_TRUE(finds.findings().empty());
}

}  // namespace
}  // namespace slackwater::api::run_finds_test
