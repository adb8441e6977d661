#include "fields/wave/height_error.h"

#include <gtest/gtest.h>

namespace slackwater::height_error_test {
namespace {

TEST(WaveHeightError, IsThePublishedTableAtItsOwnPlaces) {
  EXPECT_DOUBLE_EQ(wave_height_sigma_m(1, 12), 0.34);
  EXPECT_DOUBLE_EQ(wave_height_sigma_m(2, 48), 0.54);
  EXPECT_DOUBLE_EQ(wave_height_sigma_m(6, 72), 1.37);
}

TEST(WaveHeightError, IsLinearBetweenAndHeldBeyond) {
  EXPECT_DOUBLE_EQ(wave_height_sigma_m(3, 12), (0.42 + 0.66) / 2);
  EXPECT_DOUBLE_EQ(wave_height_sigma_m(1, 60), (0.39 + 0.43) / 2);
  EXPECT_DOUBLE_EQ(wave_height_sigma_m(9, 300), 1.37);
  EXPECT_DOUBLE_EQ(wave_height_sigma_m(1, 0), 0.34);
}

TEST(WaveHeightError, OfALowSeaIsInProportionToItsHeight) {
  EXPECT_DOUBLE_EQ(wave_height_sigma_m(0.5, 12), 0.17);
  EXPECT_DOUBLE_EQ(wave_height_sigma_m(0, 24), 0);
}

}  // namespace
}  // namespace slackwater::height_error_test
