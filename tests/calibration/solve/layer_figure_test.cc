// What products say of the mixed layer, and what a day makes of it.
#include "calibration/solve/layer_figure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "calibration/solve/ageing.h"
#include "tests/calibration/solve/unsteady_day.h"

namespace slackwater::calibration::layer_figure_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(LayerFigure, ALinearThermoclineIsCrossedWhereTheLineSays) {
  // 20 C down to 20 m, then 0.05 K a metre: 0.2 K is reached at 24 m.
  const auto figure = layer_of_profile({1, 5, 10, 15, 20, 30, 50},
                                       {293.15, 293.15, 293.15, 293.15, 293.15, 292.65, 291.65});
  ASSERT_TRUE(figure);
  EXPECT_NEAR(figure->depth_m, 24.0, 1e-9);
  EXPECT_EQ(figure->source, "thetao");
}

TEST(LayerFigure, TheReferenceIsTheWaterAtTenMetresNotTheSunWarmedTop) {
  // Half a degree warmer at 1 m; between 9 and 11 m the profile bends, 10 m lies in the middle.
  const auto figure = layer_of_profile({1, 9, 11, 21}, {293.6, 293.1, 293.0, 292.0});
  ASSERT_TRUE(figure);
  // T(10) = 293.05; 292.85 is reached 1.5 m below 11 m at 0.1 K a metre.
  EXPECT_NEAR(figure->depth_m, 12.5, 1e-9);
}

TEST(LayerFigure, WarmWaterBelowColdBoundsTheLayerToo) {
  const auto figure = layer_of_profile({0, 10, 30, 50}, {275.0, 275.0, 275.0, 276.0});
  ASSERT_TRUE(figure);
  EXPECT_NEAR(figure->depth_m, 34.0, 1e-9);
}

TEST(LayerFigure, WideLevelsMakeTheFigureLessSure) {
  const auto fine = layer_of_profile({10, 28, 30, 32}, {290, 290, 290, 289.7});
  const auto coarse = layer_of_profile({10, 30, 120}, {290, 290, 280});
  ASSERT_TRUE(fine && coarse);
  EXPECT_LT(fine->log_sigma, 0.41);
  // 90 m between two levels about 31.8 m: 90 / (sqrt(12) 31.8) = 0.817, with 0.4 in quadrature.
  EXPECT_NEAR(coarse->log_sigma, std::hypot(0.4, 90 / (std::sqrt(12.0) * 31.8)), 1e-9);
}

TEST(LayerFigure, MixedWaterAndShortProfilesSayNothing) {
  EXPECT_FALSE(layer_of_profile({1, 10, 30}, {290, 290, 289.9}));
  EXPECT_FALSE(layer_of_profile({1, 5, 9}, {290, 289, 288}));
  EXPECT_FALSE(layer_of_profile({1, 10, 30}, {290, 290, nan}));
  EXPECT_FALSE(layer_of_profile({}, {}));
}

TEST(LayerFigure, AStatedDepthIsTheGeometricMeanOfTheDay) {
  const auto figure = stated_layer({10, 40, nan, 0});
  ASSERT_TRUE(figure);
  EXPECT_NEAR(figure->depth_m, 20.0, 1e-12);
  EXPECT_EQ(figure->source, "mlotst");
  EXPECT_FALSE(stated_layer({nan}));
}

TEST(LayerFigure, YesterdaysRatioToTheProductIsCarriedOn) {
  const LayerFigure was{20, 0.4, "mlotst"};
  const LayerFigure is{30, 0.4, "mlotst"};
  // Nothing learnt: the figure itself.
  const auto first = with_layer({{"stress_factor", 1.1, 0.1}}, std::nullopt, is);
  ASSERT_EQ(first.size(), 2U);
  EXPECT_EQ(first[1].value, 30);
  EXPECT_EQ(first[1].source, "mlotst of the day");
  // Yesterday's fit was half of the product's figure: half of today's.
  const auto later = with_layer({{"mixed_layer_depth", 10, 0.3}}, was, is);
  ASSERT_EQ(later.size(), 1U);
  EXPECT_DOUBLE_EQ(later[0].value, 15);
  EXPECT_EQ(later[0].sigma, 0.3);
  EXPECT_EQ(later[0].source, "the day before, aged, moved as mlotst moved");
  // Today's is not known, or yesterday's was not: what was learnt stays.
  EXPECT_EQ(with_layer({{"mixed_layer_depth", 10, 0.3}}, was, std::nullopt)[0].value, 10);
  EXPECT_EQ(with_layer({{"mixed_layer_depth", 10, 0.3}}, std::nullopt, is)[0].value, 10);
}

TEST(LayerFigure, AFigureRightWithinAFactorOfOneAndAHalfFindsTheBaseBetter) {
  double with_figure = 0;
  double without = 0;
  constexpr std::uint64_t days = 40;
  for (std::uint64_t seed = 1; seed <= days; ++seed) {
    UnsteadyDay day = random_unsteady_day(SteadyForm::mixed_layer, seed);
    Rng rng(seed, "tests/layer_figure");
    day.truth.mixed_layer_depth_m = 25 * std::exp(0.6 * rng.normal());
    // The top of the water alone, and noisy: where a product's figure is wanted.
    day.depth_m = {1, 4, 9};
    day.noise_m_s = 0.1;
    CalibrationInput input = unsteady_input(day);
    input.observation_sigma_m_s = 0.1;
    const auto error = [&](const Calibration& fitted) {
      return std::log(find_parameter(fitted, "mixed_layer_depth")->value /
                      day.truth.mixed_layer_depth_m);
    };
    without += std::pow(error(calibrate_day(input)), 2);
    const LayerFigure figure{day.truth.mixed_layer_depth_m * std::exp(0.4 * rng.normal()), 0.4,
                             "mlotst"};
    input.known = with_layer({}, std::nullopt, figure);
    with_figure += std::pow(error(calibrate_day(input)), 2);
  }
  const double better = std::sqrt(with_figure / days);
  const double alone = std::sqrt(without / days);
  RecordProperty("with_figure", std::to_string(better));
  RecordProperty("without", std::to_string(alone));
  std::printf("base of the layer, error of its logarithm: %.3f with the figure, %.3f without\n",
              better, alone);
  EXPECT_LT(better, 0.9 * alone);
}

}  // namespace
}  // namespace slackwater::calibration::layer_figure_test
