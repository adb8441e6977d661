#include "fields/wave/height_error.h"

#include <gtest/gtest.h>

#include <cmath>

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

TEST(HeightError, IsOfTheLogarithmCountedFromBelowTheSurface) {
  EXPECT_DOUBLE_EQ(height_error::height_at(1.7, 0.25, 0), 1.7);
  EXPECT_NEAR(height_error::height_at(1.7, 0.25, 1), 2 * std::exp(0.25) - 0.3, 1e-12);
  EXPECT_EQ(height_error::height_at(0, 0.4, -1), 0) << "never below calm";
  EXPECT_GT(height_error::height_at(0, 0.4, 1), 0.1) << "a calm sea can rise";
  EXPECT_TRUE(std::isnan(height_error::height_at(std::nan(""), 0.4, 1)));
  // A small error in metres is one of the logarithm over the height from there.
  EXPECT_NEAR(height_error::of_sigma(1.7, 0.02), 0.01, 1e-6);
  EXPECT_DOUBLE_EQ(height_error::of_product(2, 48), height_error::of_sigma(2, 0.54));
}

TEST(HeightError, OfAKeptSeaGrowsFromNothingAndEnds) {
  EXPECT_EQ(height_error::of_kept(0), 0);
  EXPECT_NEAR(height_error::of_kept(26), 0.48 * std::sqrt(1 - std::exp(-1.0)), 1e-12);
  EXPECT_NEAR(height_error::of_kept(1000), 0.48, 1e-9);
}

}  // namespace
}  // namespace slackwater::height_error_test
