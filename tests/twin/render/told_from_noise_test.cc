#include "twin/render/stage/told_from_noise.h"

#include <gtest/gtest.h>

#include <cmath>

namespace slackwater::twin::told_from_noise_test {
namespace {

constexpr int side = 20;

LightFrame even_light(float of) {
  LightFrame frame;
  frame.wide = frame.high = side;
  frame.light.assign(side * side, {of, of, of});
  return frame;
}

/// Marks 1 and 3 on 100 and 25 pixels; 2 is hidden.
TruthFrame truth_of_three() {
  TruthFrame truth;
  truth.wide = truth.high = side;
  truth.defect.assign(side * side, 0);
  for (std::size_t i = 0; i < 100; ++i) truth.defect[i] = 1;
  for (std::size_t i = 200; i < 225; ++i) truth.defect[i] = 3;
  return truth;
}

LightFrame with_marks(LightFrame bare, const TruthFrame& truth, float of) {
  for (std::size_t i = 0; i < bare.light.size(); ++i)
    if (truth.defect[i] > 0) bare.light[i] = {of, of, of};
  return bare;
}

TEST(ToldFromNoise, IsTheRootOfManyPixelsTimesThatOfOne) {
  const TruthFrame truth = truth_of_three();
  const LightFrame bare = even_light(1);
  ImageSensor sensor;
  sensor.full_light = 10;
  sensor.full_well_e = 10000;  // 1 000 electrons of a light of 1
  sensor.read_noise_e = 5;
  const auto told = told_from_noise(with_marks(bare, truth, 1.01F), bare, truth, sensor, 1, 3);
  const double of_one = 10 / std::sqrt(1025.0);  // of a pixel's colour
  ASSERT_EQ(told.size(), 3U);
  EXPECT_NEAR(told[0], std::sqrt(300.0) * of_one, 1e-3 * told[0]);
  EXPECT_EQ(told[1], 0);
  EXPECT_NEAR(told[2], std::sqrt(75.0) * of_one, 1e-3 * told[2]);
}

TEST(ToldFromNoise, IsNoneWhereBothAreBrighterThanTheWellHolds) {
  const TruthFrame truth = truth_of_three();
  const LightFrame bare = even_light(8);
  const ImageSensor sensor;  // full at 9, or at 9 / gain
  const LightFrame marked = with_marks(bare, truth, 7);
  EXPECT_GT(told_from_noise(marked, bare, truth, sensor, 1, 3)[0], 5);
  EXPECT_EQ(told_from_noise(marked, bare, truth, sensor, 2, 3)[0], 0);
}

/// A statistic of the noise itself: the ideal observer's score over many developed pictures is
/// normal with this ratio between its means.
TEST(ToldFromNoise, IsWhatTheIdealObserverGetsOfDevelopedPictures) {
  const TruthFrame truth = truth_of_three();
  const LightFrame bare = even_light(1), marked = with_marks(bare, truth, 1.05F);
  ImageSensor sensor;
  sensor.most_gain = 1;  // exposed alike, whatever is in the picture
  std::vector<double> scores[2];
  double gain = 1;
  for (std::uint64_t seed = 0; seed < 300; ++seed)
    for (const bool is_marked : {false, true}) {
      const Picture picture = developed(is_marked ? marked : bare, sensor, seed * 2 + is_marked, 1);
      gain = picture.gain;
      double sum = 0;
      for (std::size_t i = 0; i < 300; ++i) sum += picture.rgb[i];  // the pixels of mark 1
      scores[is_marked].push_back(sum);
    }
  const auto mean_of = [](const std::vector<double>& of) {
    double sum = 0;
    for (const double one : of) sum += one;
    return sum / static_cast<double>(of.size());
  };
  const double without = mean_of(scores[0]), with = mean_of(scores[1]);
  double squares = 0;
  for (const double one : scores[0]) squares += (one - without) * (one - without);
  const double measured = (with - without) / std::sqrt(squares / 299);
  const double told = told_from_noise(marked, bare, truth, sensor, gain, 3)[0];
  EXPECT_NEAR(measured / told, 1, 0.12);  // 300 draws: 4 % of a standard deviation, and 8 bits
}

}  // namespace
}  // namespace slackwater::twin::told_from_noise_test
