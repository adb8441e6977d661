#include "twin/render/lens/marine_snow.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/twin/render/ranging_for_tests.h"
#include "twin/inspection/instrument/seen_light.h"
#include "twin/render/frame/truth_frame.h"

namespace slackwater::twin::marine_snow_test {
namespace {

constexpr int wide = 160, high = 90;

Pinhole camera() { return {looking({0, 0, 10}, {1, 0, 10}), frame_of(wide, high, 64)}; }

MarineSnow snow_of(double per_m3) {
  MarineSnow snow;
  snow.flakes.per_m3 = per_m3;
  snow.flakes.reach_m = 2;
  return snow;
}

LightFrame dark() {
  LightFrame frame;
  frame.wide = wide;
  frame.high = high;
  frame.light.assign(static_cast<std::size_t>(wide * high), {0, 0, 0});
  return frame;
}

/// Nothing is met.
FrameHits open_water() {
  FrameHits hits;
  const RenderScene scene;
  (void)truth_of(scene, camera(), 10, 1, hits);
  return hits;
}

double green_of(const LightFrame& frame) {
  double sum = 0;
  for (const auto& light : frame.light) sum += static_cast<double>(light[green]);
  return sum;
}

// A pyramid of w/f by h/f at a unit of depth: its volume by thin slices.
TEST(MarineSnow, AsManyFlakesAsStated) {
  double volume = 0;
  const double across = 2 * std::tan(32 * constants::degree), up = across * high / wide;
  constexpr int slices = 10000;
  for (int i = 0; i < slices; ++i) {
    const double z = 0.1 + (i + 0.5) / slices * 1.9;
    volume += across * z * up * z * 1.9 / slices;
  }
  EXPECT_NEAR(volume_in_view_m3(camera(), 0.1, 2), volume, 1e-6);
  for (const double per_m3 : {3.0, 80.0}) {
    constexpr int pictures = 400;
    double sum = 0, squares = 0;
    const double mean = per_m3 * volume;
    for (std::uint64_t seed = 0; seed < pictures; ++seed) {
      const auto count =
          static_cast<double>(flakes_in_view(snow_of(per_m3), camera(), seed).size());
      sum += count / pictures;
      squares += (count - mean) * (count - mean) / pictures;
    }
    EXPECT_NEAR(sum, mean, 4 * std::sqrt(mean / pictures));
    EXPECT_NEAR(squares / mean, 1, 4 * std::sqrt((2 + 1 / mean) / pictures)) << "Poisson";
  }
}

TEST(MarineSnow, FlakesAreEvenlyInTheWater) {
  std::array<double, 4> by_depth{}, by_column{};
  double all = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed)
    for (const Speck& flake : flakes_in_view(snow_of(80), camera(), seed)) {
      const double share = (std::pow(flake.depth_m, 3) - 0.001) / (8 - 0.001);
      ASSERT_GE(share, -1e-9);
      ASSERT_LT(share, 1 + 1e-9);
      ++by_depth[static_cast<std::size_t>(std::clamp(4 * share, 0.0, 3.999))];
      ++by_column[static_cast<std::size_t>(4 * flake.u / wide)];
      ++all;
    }
  for (const double count : by_depth) EXPECT_NEAR(count / all, 0.25, 4 * std::sqrt(0.1875 / all));
  for (const double count : by_column) EXPECT_NEAR(count / all, 0.25, 4 * std::sqrt(0.1875 / all));
}

// A disc of pi (f d/2z)^2 pixels, each as bright as a place of its reflectance in the lamp's light
// and the day's.
TEST(MarineSnow, AFlakeAddsTheLightOfItsDisc) {
  const MarineSnow snow = snow_of(1);
  Lighting lighting;
  lighting.water = coloured({0.4, 0.6, 0.1, 0}, {"test", {0.33, 0.19, 0.39}, "", ""});
  lighting.lamps = {{{0, 0, 10}, {1, 0, 0}, 1.5}};
  const FrameHits hits = open_water();
  for (const double z : {0.3, 0.9, 1.8}) {
    const Speck flake{100.2, 40.7, z};
    const LightFrame out = with_flakes(dark(), {flake}, snow, lighting, 0, camera(), hits);
    const Pinhole eye = camera();
    const Triple<double> way = eye.direction(flake.u, flake.v);
    const double s = z / way.x, depth_m = 10 + s * way.z;
    const double day = 0.6 * std::exp(-0.1 * depth_m);
    const double lamp = 1.5 * 1.5 / (s * s) * way.x * std::exp(-0.4 * s);
    const double area = constants::pi * std::pow(eye.focal_u() * 0.001 / z, 2);
    EXPECT_NEAR(
        green_of(out) / (area * 0.3 / usual_reflectance * (day + lamp) * std::exp(-0.4 * s)), 1,
        1e-4)
        << z;
  }
}

TEST(MarineSnow, BehindSomethingNothingIsSeen) {
  const Cast cast(wall_mesh(1));
  FrameHits hits;
  (void)truth_of(cast.scene, camera(), 10, 1, hits);
  Lighting lighting;
  lighting.water = coloured({0.4, 0.6, 0.1, 0}, {"test", {0.33, 0.19, 0.39}, "", ""});
  const auto seen = [&](double z) {
    return green_of(
        with_flakes(dark(), {{80.5, 45.5, z}}, snow_of(1), lighting, 0, camera(), hits));
  };
  EXPECT_GT(seen(0.99), 0);
  EXPECT_EQ(seen(1.01), 0);
}

TEST(MarineSnow, IsTheSameFromTheSameSeed) {
  const auto one = flakes_in_view(snow_of(80), camera(), 5),
             two = flakes_in_view(snow_of(80), camera(), 5);
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].u, two[i].u);
  EXPECT_NE(one.size(), flakes_in_view(snow_of(80), camera(), 6).size());
}

}  // namespace
}  // namespace slackwater::twin::marine_snow_test
