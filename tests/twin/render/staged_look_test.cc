#include "twin/render/stage/staged_look.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "tests/support/contains.h"
#include "tests/support/shared_data.h"

namespace slackwater::twin::staged_look_test {
namespace {

using slackwater::tests::contains;

const std::filesystem::path& data() {
  static const std::filesystem::path folder = slackwater::tests::source_folder() / "data";
  return folder;
}

/// A pile so thick that it is all but a wall; lines that begin with a key of `others` are those.
LookStage stage_with(const std::vector<std::string>& others = {}) {
  std::string yaml = R"(name: test
source: test
sensor: rov_camera
range_m: [0.5, 2]
off_square_deg: [0, 40]
roll_deg: 10
visibility_m: [3, 10]
daylight: [0.1, 1]
lamps: [0.8, 1]
growth: [0.3, 0.5]
waters: [coastal_1, oceanic_iii]
share_without: 0
most_defects: 2
defects: [{kind: corrosion, size_m: [0.1, 0.3]}]
surfaces: [{kind: monopile, north_m: 0, east_m: 0, radius_m: 40, )"
                     R"(from: {depth_m: 4}, to: {depth_m: 14}, bearings_deg: [-5, 5]}]
)";
  for (const std::string& other : others) {
    const auto at = yaml.find("\n" + other.substr(0, other.find(':') + 1)) + 1;
    yaml.replace(at, yaml.find('\n', at) - at, other);
  }
  return read_look_stage(Config::parse(yaml, "test.yaml"), data());
}

std::string refusal_of(const std::string& other) {
  try {
    (void)stage_with({other});
  } catch (const Error& error) {
    return error.message();
  }
  return {};
}

TEST(StagedLook, IsTheSameOnAnyNumberOfThreadsAndInAnyOrder) {
  const Stage one(stage_with()), other(stage_with());
  (void)other.look(7, 4, 1);
  const StagedLook a = one.look(7, 3, 1), b = other.look(7, 3, 3);
  EXPECT_EQ(a.picture.rgb, b.picture.rgb);
  EXPECT_EQ(a.truth.defect, b.truth.defect);
  EXPECT_EQ(a.defects.size(), b.defects.size());
  EXPECT_NE(one.look(7, 5, 1).picture.rgb, a.picture.rgb);
  EXPECT_NE(one.look(8, 3, 1).picture.rgb, a.picture.rgb);
}

TEST(StagedLook, LooksFromAsFarAndAsAskewAsItSays) {
  const Stage stage(stage_with());
  for (std::uint64_t i = 0; i < 4; ++i) {
    const StagedLook look = stage.look(1, i, 1);
    const auto middle = static_cast<std::size_t>(180 * 640 + 320);
    EXPECT_NEAR(look.truth.depth_m[middle], look.range_m, 0.01 * look.range_m) << i;
    // The pile is a prism: its faces stand up to half of a patch's angle off the patch's normal.
    EXPECT_NEAR(look.truth.normal[middle][2], -std::cos(look.off_square_rad), 0.01) << i;
    EXPECT_GE(look.range_m, 0.5);
    EXPECT_LE(look.range_m, 2);
  }
}

TEST(StagedLook, SquareToAWallSeesItsFootprint) {
  const Stage stage(stage_with({"off_square_deg: [0, 0]", "range_m: [1, 1]", "defects: []",
                                "most_defects: 0", "roll_deg: 0"}));
  const double wide_m = 2 * std::tan(32 * constants::degree);
  // A wall of 40 m radius falls back by 5 mm at the picture's edges: 1 % of 0.88 m2.
  EXPECT_NEAR(stage.look(1, 0, 1).seen_m2, wide_m * wide_m * 9 / 16, 0.01);
}

TEST(StagedLook, ADefectShowsOnAsMuchOfTheSurfaceAsItHas) {
  // All square to the wall at one metre: a pixel covers (z / f)^2.
  const Stage stage(stage_with({"off_square_deg: [0, 0]", "range_m: [1, 1]", "most_defects: 1"}));
  const double focal = 320 / std::tan(32 * constants::degree);
  std::size_t whole = 0;
  for (std::uint64_t i = 0; whole < 2 && i < 30; ++i) {
    const StagedLook look = stage.look(2, i, 1);
    ASSERT_EQ(look.defects.size(), 1U);
    const StagedDefect& planted = look.defects[0];
    EXPECT_GE(planted.size_m, 0.1);
    EXPECT_LE(planted.size_m, 0.3);
    const double reach = 0.5 * planted.size_m * focal + 2;
    if (planted.centre_px[0] < reach || planted.centre_px[0] > 640 - reach ||
        planted.centre_px[1] < reach || planted.centre_px[1] > 360 - reach)
      continue;
    ++whole;
    const double shown_m2 = static_cast<double>(planted.pixels) / (focal * focal);
    // By pixels' middles: of an ellipse of 50 x 20 pixels or more within half a pixel all round.
    EXPECT_NEAR(shown_m2, constants::pi / 4 * planted.size_m * planted.width_m, 0.03 * shown_m2);
    // What the inspection says of the place: nothing moves, and a pixel aside is seen up to a
    // quarter wider than one in the middle.
    EXPECT_NEAR(planted.quality.ground_sampling_m, planted.quality.range_m / focal, 0.25 / focal);
    EXPECT_NEAR(
        planted.quality.detail_m,
        planted.quality.ground_sampling_m / (planted.quality.contrast * planted.quality.light),
        1e-9);
  }
  EXPECT_GE(whole, 2U);
}

TEST(StagedLook, AsManyAreBareAsTheStageSays) {
  LookStage sheet = stage_with({"share_without: 0.4"});
  FrameFootprint& small = std::get<CameraSheet>(sheet.sensor.device).frame;
  small.pixels_wide = 64, small.pixels_high = 36;
  const Stage stage(sheet);
  int bare = 0;
  for (std::uint64_t i = 0; i < 40; ++i) bare += stage.look(3, i, 1).defects.empty() ? 1 : 0;
  EXPECT_NEAR(bare, 16, 12);  // four standard deviations
}

TEST(StagedLook, EveryFileOfTheFolderIsAStageThatCanBeLookedAt) {
  std::size_t read = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data() / "stages")) {
    const Stage stage(read_look_stage(Config::load(entry.path()), data()));
    EXPECT_FALSE(stage.look(1, 0, 1).picture.rgb.empty()) << entry.path();
    ++read;
  }
  EXPECT_GE(read, 2U);
}

TEST(StagedLook, RefusesWhatCannotBe) {
  EXPECT_TRUE(contains(refusal_of("sensor: uav_lidar"), "which is no camera"));
  EXPECT_TRUE(contains(refusal_of("range_m: [2, 0.5]"), "the lower one first"));
  EXPECT_TRUE(contains(refusal_of("range_m: [0.5, 300]"), "sees from 0.05 to 30 m"));
  EXPECT_TRUE(contains(refusal_of("defects: [{kind: scour, size_m: [1, 2]}]"),
                       "sits on none of the stage's surfaces"));
  EXPECT_TRUE(contains(refusal_of("defects: [{kind: rust, size_m: [1, 2]}]"), "found rust"));
  EXPECT_TRUE(contains(refusal_of("waters: [lemonade]"), "lemonade"));
  EXPECT_TRUE(contains(refusal_of("surfaces: []"), "surfaces"));
}

TEST(StagedLook, SaysWhereNoPlaceCanBeLookedAt) {
  const Stage dry(
      stage_with({"surfaces: [{kind: tower, north_m: 0, east_m: 0, radius_m: 3, from: "
                  "{height_m: 60}, to: {height_m: 20}}]"}));
  try {
    (void)dry.look(1, 0, 1);
    FAIL() << "a camera of the water looks at a tower";
  } catch (const Error& error) {
    EXPECT_TRUE(contains(error.message(), "a thousand draws")) << error.message();
  }
}

}  // namespace
}  // namespace slackwater::twin::staged_look_test
