// Rust by its colour and cracks by their form, on plates on which they are known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "api/perception/detector.h"
#include "fields/base/numbers/random.h"
#include "tests/api/perception/plates_for_tests.h"

namespace slackwater::tests::classical_detectors_test {
namespace {

using api::Detection;
using api::PixelBox;
using twin::Picture;

std::vector<Detection> found_by(const char* detector, const Picture& picture) {
  return api::load_detector(detector)->find(picture);
}
std::vector<Detection> rust_in(const Picture& picture) {
  return found_by("corrosion_by_colour", picture);
}
std::vector<Detection> cracks_in(const Picture& picture) {
  return found_by("crack_by_percolation", picture);
}

TEST(CorrosionByColour, BoundsAPatchOfRust) {
  Picture picture = plate(120, 80);
  paint(picture, 30, 20, 50, 60, rust);
  const auto found = rust_in(picture);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].of, "corrosion");
  EXPECT_EQ(found[0].box, (PixelBox{30, 20, 50, 60}));
  EXPECT_GT(found[0].confidence, 0.3);
}

TEST(CorrosionByColour, TellsPatchesApartThatDoNotTouch) {
  Picture picture = plate(120, 80);
  paint(picture, 10, 10, 30, 30, rust);
  paint(picture, 31, 31, 50, 50, rust);
  EXPECT_EQ(rust_in(picture).size(), 2U);
  paint(picture, 30, 30, 31, 31, rust);  // by a corner
  EXPECT_EQ(rust_in(picture).size(), 1U);
}

TEST(CorrosionByColour, FindsNothingInGreyBlueOrGreen) {
  for (const Colour& colour : {steel, Colour{20, 60, 140}, Colour{40, 110, 50}, Colour{0, 0, 0},
                               Colour{255, 255, 255}, Colour{240, 220, 210}}) {
    EXPECT_TRUE(rust_in(plate(64, 64, colour)).empty()) << int{colour[0]};
  }
}

TEST(CorrosionByColour, TakesDustForNothing) {
  Picture picture = plate(64, 64);
  paint(picture, 10, 10, 15, 15, rust);  // 25 pixels of 30
  EXPECT_TRUE(rust_in(picture).empty());
}

TEST(CrackByPercolation, BoundsADarkLine) {
  Picture picture = plate(200, 120);
  paint(picture, 40, 60, 160, 62, {60, 60, 60});
  const auto found = cracks_in(picture);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].of, "crack");
  EXPECT_EQ(found[0].box.top, 60);
  EXPECT_EQ(found[0].box.bottom, 62);
  // At its ends the region fills the window's half: within that of the truth.
  EXPECT_NEAR(found[0].box.left, 40, 21);
  EXPECT_NEAR(found[0].box.right, 160, 21);
}

TEST(CrackByPercolation, SeesTheSameWhenThePictureIsTurned) {
  Picture across = plate(150, 150), down = plate(150, 150);
  for (int i = 0; i < 100; ++i) {
    const int aside = 60 + static_cast<int>(std::lround(8 * std::sin(i / 9.0)));
    paint(across, 25 + i, aside, 26 + i, aside + 2, {50, 50, 50});
    paint(down, aside, 25 + i, aside + 2, 26 + i, {50, 50, 50});
  }
  const auto of_across = cracks_in(across), of_down = cracks_in(down);
  ASSERT_EQ(of_across.size(), 1U);
  ASSERT_EQ(of_down.size(), 1U);
  EXPECT_NEAR(of_across[0].box.left, of_down[0].box.top, 3);
  EXPECT_NEAR(of_across[0].box.bottom, of_down[0].box.right, 3);
  EXPECT_NEAR(of_across[0].confidence, of_down[0].confidence, 0.05);
}

TEST(CrackByPercolation, TakesADiscAShadeAndNoiseForNone) {
  Picture disc = plate(150, 150);
  for (int row = 0; row < 150; ++row)
    for (int column = 0; column < 150; ++column)
      if (std::hypot(row - 75, column - 75) < 12)
        paint(disc, column, row, column + 1, row + 1, {50, 50, 50});
  EXPECT_TRUE(cracks_in(disc).empty());
  Picture shade = plate(150, 150);
  for (int column = 0; column < 150; ++column) {
    const auto level = static_cast<std::uint8_t>(60 + column);
    paint(shade, column, 0, column + 1, 150, {level, level, level});
  }
  EXPECT_TRUE(cracks_in(shade).empty());
  Picture grain = plate(150, 150);
  Rng rng(1, "grain");
  for (std::uint8_t& byte : grain.rgb) byte = static_cast<std::uint8_t>(140 + 6 * rng.normal());
  EXPECT_TRUE(cracks_in(grain).empty());
}

TEST(CrackByPercolation, LooksAtPicturesSmallerThanItsWindow) {
  EXPECT_TRUE(cracks_in(plate(5, 3)).empty());
  EXPECT_TRUE(cracks_in(plate(1, 1, {0, 0, 0})).empty());
  EXPECT_TRUE(rust_in(plate(1, 1, rust)).empty());
}

}  // namespace
}  // namespace slackwater::tests::classical_detectors_test
