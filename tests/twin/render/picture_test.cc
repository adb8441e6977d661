#include "twin/render/lens/picture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "tests/twin/inspection/meshes_for_tests.h"
#include "tests/twin/render/render_for_tests.h"
#include "twin/inspection/instrument/seen_light.h"
#include "twin/render/light/albedo.h"
#include "twin/render/light/fading.h"
#include "twin/render/light/lamp_veil.h"
#include "twin/render/light/light_frame.h"

namespace slackwater::twin::picture_test {
namespace {

/// An upright wall `ahead_m` north of the origin, of a material that has one albedo all over, which
/// faces south; the sea far above.
RenderScene wall(double ahead_m, double half_m = 40) {
  RenderScene scene;
  scene.surface_m = -20;
  TriangleMesh mesh;
  mesh.origin_m = {ahead_m, 0, 0};
  const auto s = static_cast<float>(half_m);
  mesh.corners = {{0, -s, -s}, {0, s, -s}, {0, s, s}, {0, -s, s}};
  mesh.triangles = {{0, 2, 1}, {0, 3, 2}};
  scene.things.push_back({"wall", SeenClass::structure, Material::none, mesh});
  return scene;
}

/// What the middle of a small picture from the origin, looking north, sees: of green.
double seen_ahead(const RenderScene& scene, const Lighting& lighting) {
  const Pinhole camera(looking({0, 0, 0}, {1, 0, 0}), frame_of(5, 5, 1));
  FrameHits hits;
  find_first_hits(camera, std::vector<const TriangleMesh*>{&scene.things[0].mesh}, 1e3, 1, hits);
  return static_cast<double>(light_of(scene, lighting, camera, hits, 1).light[12][green]);
}

const WaterType& coastal() {
  static const WaterType type{"test", {0.33, 0.19, 0.39}, "", ""};
  return type;
}

constexpr double of_a_float = 1e-6;

TEST(Fading, IsTheExponentialToRounding) {
  for (double x = -30; x < 700; x += 0.37) EXPECT_NEAR(fading(x) / std::exp(-x), 1, 2e-14) << x;
  EXPECT_EQ(fading(0), 1);
  EXPECT_EQ(fading(1e9), 0);
  for (double x = 1e-12; x < 1e12; x *= 1.7)
    EXPECT_NEAR(logarithm(x), std::log(x), 1e-13 * (1 + std::abs(std::log(x)))) << x;
  EXPECT_NEAR(faded_length_m(0.3, 7), (1 - std::exp(-2.1)) / 0.3, 1e-13);
  EXPECT_NEAR(faded_length_m(1e-9, 7), 7, 1e-7);
}

// The place is lit by day alone: its light falls off with the beam, the water's comes in its place.
TEST(Picture, ByDayIsBeerLambertAndTheWatersVeil) {
  Lighting lighting;
  const Clarity clarity{0.6, 0.8, 0.15, 0.009};
  lighting.water = coloured(clarity, coastal());
  for (const double range_m : {0.5, 2.0, 6.0}) {
    const double day = 0.8 * std::exp(-0.15 * 20);
    const double left = std::exp(-0.6 * range_m);
    // All of one albedo, the usual one.
    EXPECT_NEAR(seen_ahead(wall(range_m), lighting), day * left + day * (1 - left), of_a_float);
  }
}

TEST(Picture, ByDayTwoPlacesDifferByTheBeamAlone) {
  Lighting lighting;
  lighting.water = coloured({0.6, 1, 0.15, 0.009}, coastal());
  RenderScene near = wall(1e-3), far = wall(3);
  const auto contrast = [&](RenderScene scene) {
    const double usual = seen_ahead(scene, lighting);
    scene.things[0].material = Material::water;  // of one albedo, too
    return usual - seen_ahead(scene, lighting);
  };
  EXPECT_NEAR(contrast(far) / contrast(near), std::exp(-0.6 * (3 - 1e-3)), 1e-5);
}

/// A camera of the inspection, with a lamp beside its lens, and the picture's of the same.
struct Case {
  Clarity clarity;
  double range_m;
  double lamp_range_m;
};

class PictureAndInspection : public ::testing::TestWithParam<Case> {};

// One model: light and contrast that the inspection tells of are those of the picture. It leaves
// out that the lamp's light falls a little aslant, r/r_l, which the picture has.
TEST_P(PictureAndInspection, TellOfOneLight) {
  const Case& given = GetParam();
  Instrument instrument;
  instrument.kind = InstrumentKind::rgb;
  instrument.needs_light = true;
  instrument.lamp_range_m = given.lamp_range_m;
  instrument.lamp_aside_m = 0.2;
  constexpr double depth_m = 20;
  const SeenLight told = seen_light(instrument, given.clarity, depth_m, given.range_m);
  ASSERT_LT(told.light, 1) << "else it says no more than enough";
  Lighting lighting;
  lighting.water = coloured(given.clarity, coastal());
  if (given.lamp_range_m > 0)
    lighting.lamps.push_back({{0, 0.2, 0}, {1, 0, 0}, given.lamp_range_m});
  RenderScene scene = wall(given.range_m);
  const double light = seen_ahead(scene, lighting);
  // The veil alone: what comes of a black place is none of the place's. Two albedos give it.
  scene.things[0].material = Material::water;
  const double dark = seen_ahead(scene, lighting);
  const double dark_share = albedo_of(Material::water, {}, 0)[green] / usual_reflectance;
  const double veil = (dark - dark_share * light) / (1 - dark_share);
  const double aslant = given.range_m / std::hypot(given.range_m, 0.2);
  const double all_of_lamp = given.lamp_range_m > 0 ? 1 - aslant : 0;
  EXPECT_NEAR(light, told.light, of_a_float + all_of_lamp * told.light);
  EXPECT_NEAR(1 - veil / light, told.contrast, 1e-5 + all_of_lamp);
}

INSTANTIATE_TEST_SUITE_P(Waters, PictureAndInspection,
                         ::testing::Values(Case{{0.6, 0.9, 0.15, 0.009}, 2, 0},
                                           Case{{1.5, 0.9, 0.4, 0.02}, 1, 0},
                                           Case{{0.6, 0, 0.15, 0.009}, 2.5, 2},
                                           Case{{1.0, 0, 0.25, 0.015}, 2, 1.5},
                                           Case{{0.3, 0.3, 0.075, 0.0045}, 3, 1}));

TEST(LampVeilAnywhere, IsTheInspectionsIntegralForALampBesideTheLens) {
  const Lamp lamp{{0, 0.2, 0}, {1, 0, 0}, 2};
  const Ray ahead{{0, 0, 0}, {1, 0, 0}};
  for (const double c : {0.0, 0.3, 1.2})
    for (const double range_m : {0.1, 1.0, 8.0})
      EXPECT_NEAR(lamp_veil_along_per_m(lamp, ahead, range_m, c), lamp_veil_per_m(c, 0.2, range_m),
                  1e-12);
}

/// By so many points one after the other.
void expect_veil(const Lamp& lamp, const Ray& ray, double tolerance) {
  constexpr double c = 0.5, range_m = 6;
  constexpr int steps = 200000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double s = (i + 0.5) * range_m / steps;
    const Triple<double> way = s * ray.direction - lamp.position_m;
    const double far_m = length_of(way), cosine = dot(way, lamp.axis) / far_m;
    const bool is_open = lamp.half_beam_rad > 1.57;
    const double dark = is_open ? -1 : std::cos(lamp.half_beam_rad);
    const double full = is_open ? 0 : std::cos(0.9 * lamp.half_beam_rad);
    const double t = std::min(1.0, std::max(0.0, (cosine - dark) / (full - dark)));
    sum += std::max(0.0, cosine) * t * t * (3 - 2 * t) / (far_m * far_m) *
           std::exp(-c * (s + far_m)) * range_m / steps;
  }
  EXPECT_NEAR(lamp_veil_along_per_m(lamp, ray, range_m, c), sum, tolerance * sum + 1e-6);
}

TEST(LampVeilAnywhere, IsTheIntegralForALampAnywhere) {
  const Ray ray{{0, 0, 0}, unit({1, 0.1, 0.05})};
  const Triple<double> beside{0.7, 0.5, -0.4};
  // Eight points, and the edge of a beam somewhere among them.
  expect_veil({beside, unit({0.9, -0.3, 0.2}), 2}, ray, 2e-3);
  expect_veil({beside, unit({0.9, -0.3, 0.2}), 2, 0.9}, ray, 0.03);
  expect_veil({beside, unit({0.9, 0.3, 0.2}), 2, 0.5}, ray, 0.03);
  expect_veil({beside, unit({-0.9, -0.8, 0.5}), 2, 0.6}, ray, 0.03);
  expect_veil({{4, 1, 0}, unit({-1, -0.4, 0}), 2}, ray, 2e-3);
  expect_veil({{4, 1, 0}, unit({-0.2, 1, 0}), 2, 0.7}, ray, 1e-9);  // points away
}

// A Lambert face turned by an angle, under a lamp far off: by its cosine; none from behind.
TEST(Picture, ALambertFaceGoesByTheCosine) {
  Lighting lighting;
  lighting.water = coloured({1e-9, 0, 0, 0}, coastal());
  for (const double turned_deg : {0.0, 35.0, 70.0, 100.0}) {
    const double turn = turned_deg * constants::degree;
    lighting.lamps = {{{1 - 50 * std::cos(turn), 50 * std::sin(turn), 0},
                       {std::cos(turn), -std::sin(turn), 0},
                       20}};
    EXPECT_NEAR(seen_ahead(wall(1), lighting),
                std::max(0.0, std::cos(turn)) * (20.0 / 50) * (20.0 / 50), 1e-6)
        << turned_deg;
  }
}

TEST(Picture, NoLampShinesThroughWhatStandsBetween) {
  Lighting lighting;
  lighting.water = coloured({1e-9, 0, 0, 0}, coastal());
  lighting.lamps = {{{0, 1, 0}, unit({3, -1, 0}), 3}};
  RenderScene scene = wall(3);
  const double lit = seen_ahead(scene, lighting);
  EXPECT_GT(lit, 0.5);
  lighting.shadows = shadows_of(scene);
  EXPECT_EQ(seen_ahead(scene, lighting), lit) << "a face is in no shadow of itself";
  scene.things.push_back({"post", SeenClass::structure, Material::none,
                          cylinder_mesh({1.5, 0.5, -2}, 0.05, 4, 12, 1)});
  lighting.shadows = shadows_of(scene);
  EXPECT_EQ(seen_ahead(scene, lighting), 0);
}

TEST(Colours, GreenIsTheInspectionsAndRedFadesFirst) {
  const Clarity clarity{0.6, 1, 0.15, 0.009};
  const ColouredClarity in = coloured(clarity, coastal());
  EXPECT_EQ(in.beam_attenuation_per_m[green], 0.6);
  EXPECT_EQ(in.diffuse_attenuation_per_m[green], 0.15);
  EXPECT_GT(in.beam_attenuation_per_m[0], 0.6);
  // a = mu K to a colour: the difference of c is that of absorption.
  EXPECT_NEAR(in.beam_attenuation_per_m[0] - 0.6, 0.83 * (0.15 * 0.33 / 0.19 - 0.15), 1e-12);
}

TEST(Sky, BeamIsMeinelsByAirMass) {
  // At the zenith the air mass is 1: 1353 * 0.7 W/m2.
  EXPECT_NEAR(clear_beam_w_m2(90), 947, 1);
  // At 30 degrees Kasten and Young have an air mass of 1.99.
  EXPECT_NEAR(clear_beam_w_m2(30), 0.5 * 1353 * std::pow(0.7, std::pow(1.994, 0.678)), 1);
  EXPECT_EQ(clear_beam_w_m2(-3), 0);
  EXPECT_EQ(clear_sky(-3, 90).beam, 0);
  EXPECT_NEAR(clear_sky(30, 90).to_sun.y, std::cos(30 * constants::degree), 1e-12);
}

TEST(Picture, IsTheSameOnAnyNumberOfThreads) {
  RenderScene scene;
  scene.surface_m = -10;
  scene.things.push_back(
      {"pile", SeenClass::monopile, Material::steel, cylinder_mesh({5, 0, -10}, 3, 40, 48, 20)});
  Lighting lighting;
  lighting.water = coloured({0.4, 1, 0.1, 0.006}, coastal());
  lighting.lamps = {{{0, 0.3, -0.2}, {1, 0, 0}, 2}};
  lighting.shadows = shadows_of(scene);
  const Pinhole camera(looking({0, 0, 0}, {5, 0.3, 0.2}), frame_of(64, 48, 64));
  FrameHits hits;
  find_first_hits(camera, std::vector<const TriangleMesh*>{&scene.things[0].mesh}, 50, 1, hits);
  const LightFrame one = light_of(scene, lighting, camera, hits, 1);
  const LightFrame three = light_of(scene, lighting, camera, hits, 3);
  EXPECT_EQ(one.light, three.light);
  EXPECT_EQ(developed(one, {}, 7, 1).rgb, developed(three, {}, 7, 3).rgb);
  EXPECT_NE(developed(one, {}, 7, 1).rgb, developed(one, {}, 8, 1).rgb);
}

// Shot noise has the variance of its mean, read noise its own.
TEST(Developed, NoiseIsShotAndRead) {
  LightFrame light;
  light.wide = 200;
  light.high = 200;
  ImageSensor sensor;
  sensor.full_well_e = 1000;
  sensor.read_noise_e = 10;
  sensor.full_light = 1;
  sensor.mean_level = 0.4;
  light.light.assign(40000, {0.4F, 0.4F, 0.4F});
  const Picture picture = developed(light, sensor, 3, 1);
  EXPECT_NEAR(picture.gain, 1, 1e-6);
  double sum = 0, squares = 0;
  for (const std::uint8_t value : picture.rgb) {
    const double y = value / 255.0;
    const double x = std::pow((y + 0.055) / 1.055, 2.4) * 1000;
    sum += x;
    squares += x * x;
  }
  const double n = static_cast<double>(picture.rgb.size());
  EXPECT_NEAR(sum / n, 400, 0.5);
  // 400 + 100, and what 256 steps add: (5.7 e)^2 / 12.
  EXPECT_NEAR(squares / n - sum / n * sum / n, 500 + 2.7, 12);
}

}  // namespace
}  // namespace slackwater::twin::picture_test
