#include "twin/render/lens/forward_scatter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/numbers/random.h"
#include "tests/twin/render/ranging_for_tests.h"
#include "twin/render/frame/truth_frame.h"

namespace slackwater::twin::forward_scatter_test {
namespace {

constexpr int wide = 121, high = 81;
constexpr double c_per_m = 0.5;

struct Seen {
  Cast cast;
  Pinhole camera{looking({0, 0, 0}, {1, 0, 0}), frame_of(wide, high, 20)};
  FrameHits hits;

  explicit Seen(double away_m) : cast(wall_mesh(away_m)) {
    (void)truth_of(cast.scene, camera, 100, 1, hits);
  }
  [[nodiscard]] LightFrame scattered(const LightFrame& light, const ForwardScatter& scatter,
                                     int threads = 1) const {
    return scattered_forwards(light, scatter, camera, hits, c_per_m, threads);
  }
};

LightFrame dark() {
  LightFrame frame;
  frame.wide = wide;
  frame.high = high;
  frame.light.assign(static_cast<std::size_t>(wide * high), {0, 0, 0});
  return frame;
}

std::array<float, 3>& at(LightFrame& frame, int i, int j) {
  return frame.light[static_cast<std::size_t>(j * wide + i)];
}

double sum_of(const LightFrame& frame) {
  double sum = 0;
  for (const auto& light : frame.light)
    for (const float one : light) sum += static_cast<double>(one);
  return sum;
}

// A bright point: 1 - exp(-s c r) of it is laid about it with the variance (f spread)^2 c r, to
// both sides alike.
TEST(ForwardScatter, APointSpreadsAsStated) {
  const ForwardScatter scatter{0.7, 0.5 * constants::degree};
  for (const double away_m : {1.0, 4.0, 10.0}) {
    const Seen seen(away_m);
    LightFrame point = dark();
    at(point, 60, 40) = {1, 2, 3};
    const LightFrame out = seen.scattered(point, scatter);
    EXPECT_NEAR(sum_of(out), 6, 1e-4);
    const double way = c_per_m * away_m * 1.0;
    const double share = 1 - std::exp(-0.7 * way);
    const double variance = std::pow(seen.camera.focal_u() * scatter.spread_rad, 2) * way;
    double across = 0, along = 0, aside = 0;
    for (int j = 0; j < high; ++j)
      for (int i = 0; i < wide; ++i) {
        const double green_light =
            static_cast<double>(out.light[static_cast<std::size_t>(j * wide + i)][1]) / 2;
        across += green_light * (i - 60) * (i - 60);
        along += green_light * (j - 40) * (j - 40);
        aside += green_light * (i - 60);
      }
    // A kernel that ends at four standard deviations has lost 0.1 % of its variance.
    EXPECT_NEAR(across / (share * variance), 1, 5e-3) << away_m;
    EXPECT_NEAR(along / (share * variance), 1, 5e-3) << away_m;
    EXPECT_NEAR(aside, 0, 1e-5);
  }
}

TEST(ForwardScatter, NoLightIsWonOrLostAndAnEvenPictureStaysEven) {
  const ForwardScatter scatter{0.7, 0.5 * constants::degree};
  Seen seen(5);
  // As far off all over: where more is scattered from one place than from the next, it is not even.
  for (double& range_m : seen.hits.range_m) range_m = 5;
  LightFrame even = dark();
  for (auto& light : even.light) light = {0.3F, 0.5F, 0.7F};
  const LightFrame still = seen.scattered(even, scatter);
  for (std::size_t i = 0; i < even.light.size(); ++i) EXPECT_NEAR(still.light[i][1], 0.5, 1e-6);
  LightFrame rough = dark();
  Rng rng(3, "test/forward_scatter");
  for (auto& light : rough.light)
    for (float& one : light) one = static_cast<float>(rng.uniform());
  const LightFrame smooth = seen.scattered(rough, scatter);
  EXPECT_NEAR(sum_of(smooth) / sum_of(rough), 1, 1e-6);
  // At the edge, too.
  LightFrame corner = dark();
  at(corner, 0, 0) = {1, 1, 1};
  EXPECT_NEAR(sum_of(seen.scattered(corner, scatter)), 3, 1e-4);
}

TEST(ForwardScatter, ClearWaterAndASkyStayAsTheyAre) {
  Seen seen(5);
  LightFrame point = dark();
  at(point, 60, 40) = {1, 2, 3};
  EXPECT_EQ(scattered_forwards(point, {0.7, 0.01}, seen.camera, seen.hits, 0, 1).light,
            point.light);
  EXPECT_EQ(seen.scattered(point, {0, 0.01}).light, point.light);
  for (auto& mesh : seen.hits.mesh) mesh = FrameHits::nothing;
  EXPECT_EQ(seen.scattered(point, {0.7, 0.01}).light, point.light);
}

TEST(ForwardScatter, IsTheSameOnAnyNumberOfThreads) {
  const Seen seen(6);
  LightFrame rough = dark();
  Rng rng(3, "test/forward_scatter");
  for (auto& light : rough.light)
    for (float& one : light) one = static_cast<float>(rng.uniform());
  const ForwardScatter scatter{0.7, 0.01};
  const LightFrame one = seen.scattered(rough, scatter);
  EXPECT_NE(one.light, rough.light);
  for (const int threads : {2, 5})
    EXPECT_EQ(one.light, seen.scattered(rough, scatter, threads).light);
}

}  // namespace
}  // namespace slackwater::twin::forward_scatter_test
