#include "twin/render/lens/spray.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/twin/render/ranging_for_tests.h"
#include "twin/render/frame/truth_frame.h"
#include "twin/render/light/sky_light.h"

namespace slackwater::twin::spray_test {
namespace {

constexpr int wide = 160, high = 90;

/// Level, 5 m above the sea, northwards.
Pinhole camera() { return {looking({0, 0, -5}, {1, 0, -5}), frame_of(wide, high, 64)}; }

Specks drops_of(double diameter_m) {
  Specks spray;
  spray.diameter_m = diameter_m;
  return spray;
}

Lighting overcast() {
  Lighting lighting;
  lighting.air = colourless({1e-4, 1, 0, 0});
  lighting.water = coloured({0.4, 0.6, 0.1, 0}, {"test", {0.33, 0.19, 0.39}, "", ""});
  return lighting;
}

LightFrame even(float light) {
  LightFrame frame;
  frame.wide = wide;
  frame.high = high;
  frame.light.assign(static_cast<std::size_t>(wide * high), {light, light, light});
  return frame;
}

FrameHits nothing_met() {
  FrameHits hits;
  (void)truth_of(RenderScene{}, camera(), 10, 1, hits);
  return hits;
}

double green_at(const LightFrame& frame, int column, int row) {
  return static_cast<double>(frame.light[static_cast<std::size_t>(row * wide + column)][green]);
}

// Into a ball of n = 4/3 at 30 degrees off, sin = 1/2, it goes on at asin(3/8) = 22.02 degrees, and
// leaves 2 (30 - 22.02) = 15.95 degrees aside; at its edge 2 (90 - 48.61).
TEST(Spray, ALookGoesThroughADropBySnellsLaw) {
  const Triple<double> look{1, 0, 0}, up{0, 0, -1};
  const auto turn_deg = [&](double off) {
    const Triple<double> beyond = look_through_drop(look, up, off);
    EXPECT_NEAR(length_of(beyond), 1, 1e-12);
    EXPECT_EQ(beyond.y, 0);
    return std::atan2(beyond.z, beyond.x) / constants::degree;
  };
  EXPECT_NEAR(turn_deg(0), 0, 1e-12);
  EXPECT_NEAR(turn_deg(0.5), 15.94, 0.02) << "met above, it goes on down";
  EXPECT_NEAR(turn_deg(1), 82.79, 0.05);
}

// Near its middle a ball is a lens of focal length n R/(2 (n - 1)) from it.
TEST(Spray, NearItsMiddleADropIsALens) {
  const double off = 1e-3, lens = off / (1.333 / (2 * 0.333));
  const Triple<double> beyond = look_through_drop({1, 0, 0}, {0, 1, 0}, off);
  EXPECT_NEAR(-beyond.y / beyond.x / lens, 1, 1e-5);
}

TEST(Spray, ADropShowsTheSkyBelowAndTheSeaAbove) {
  const Lighting lighting = overcast();
  // 40 pixels across, before the horizon.
  const double z = camera().focal_u() * 0.01 / 40;
  const LightFrame out =
      with_drops(even(0), {{80, 45, z}}, drops_of(0.01), lighting, 0, camera(), nothing_met());
  const double above = green_at(out, 80, 32), below = green_at(out, 80, 57);
  EXPECT_GT(below, 2 * above);
  EXPECT_GT(above, 0);
  const double sky = sky_light(lighting, {1, 0, 0})[green];
  EXPECT_GT(below, sky) << "higher up an overcast sky is brighter";
  EXPECT_EQ(green_at(out, 80, 20), 0) << "beside it";
}

// Over all its pixels it hides its disc's area, however small.
TEST(Spray, ADropHidesItsDisc) {
  Lighting dark = overcast();
  dark.air.daylight = dark.water.daylight = 0;
  for (const double z : {0.05, 0.3, 2.0}) {
    const LightFrame out =
        with_drops(even(1), {{80.3, 45.6, z}}, drops_of(0.002), dark, 0, camera(), nothing_met());
    double hidden = 0;
    for (const auto& light : out.light) hidden += 1 - static_cast<double>(light[green]);
    EXPECT_NEAR(hidden / (constants::pi * std::pow(camera().focal_u() * 0.001 / z, 2)), 1, 1e-3)
        << z;
  }
}

// Where all about is as bright as what is behind it nobody sees it: water takes nothing away.
TEST(Spray, InAnEvenLightADropIsNotSeen) {
  Lighting lighting = overcast();
  // Fog that nothing is seen through but itself; of it, the horizon's part.
  lighting.air = colourless({100, 1, 0, 0});
  const double fog = sky_light(lighting, {1, 0, 0})[green];
  const LightFrame out = with_drops(even(static_cast<float>(fog)), {{80, 45, 0.3}}, drops_of(0.01),
                                    lighting, 0, camera(), nothing_met());
  for (int row = 30; row < 44; ++row)
    EXPECT_NEAR(green_at(out, 80, row) / fog, 1, 1e-5) << row << ": the half that looks down";
}

TEST(Spray, BehindSomethingNoDropIsSeen) {
  const Cast cast(wall_mesh(1));
  FrameHits hits;
  (void)truth_of(cast.scene, camera(), 10, 1, hits);
  const auto seen = [&](double z) {
    const LightFrame out =
        with_drops(even(0), {{80.5, 45.5, z}}, drops_of(0.002), overcast(), 0, camera(), hits);
    return green_at(out, 80, 45);
  };
  EXPECT_GT(seen(0.99), 0);
  EXPECT_EQ(seen(1.01), 0);
}

// A share 1 - exp(-n pi d^2/4 s) of a picture that is s deep, for a farther drop is smaller as
// there are more of them.
TEST(Spray, HidesAsMuchAsItsDropsAreInTheWay) {
  Specks spray = drops_of(0.002);
  spray.per_m3 = 3000;
  spray.nearest_m = 0.3;
  spray.reach_m = 2.3;
  Lighting dark = overcast();
  dark.air.daylight = dark.water.daylight = 0;
  double left = 0;
  constexpr int pictures = 30;
  const FrameHits hits = nothing_met();
  for (std::uint64_t seed = 0; seed < pictures; ++seed) {
    const LightFrame out =
        with_drops(even(1), drops_in_view(spray, camera(), seed), spray, dark, 0, camera(), hits);
    for (const auto& light : out.light)
      left += static_cast<double>(light[green]) / (pictures * wide * high);
  }
  const double depth = spray.per_m3 * constants::pi * 1e-6 * 2;
  // 320 000 drops are within 0.3 % of their mean; those that look in from outside the picture, some
  // 0.5 % of what is covered, are not drawn.
  EXPECT_NEAR(std::log(left) / -depth, 1, 0.02);
}

}  // namespace
}  // namespace slackwater::twin::spray_test
