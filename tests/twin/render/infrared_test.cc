#include "twin/render/light/infrared_frame.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "tests/support/shared_data.h"
#include "tests/twin/render/ranging_for_tests.h"
#include "twin/render/frame/truth_frame.h"

namespace slackwater::twin::infrared_test {
namespace {

using constants::pi;

constexpr double from_m = 8e-6, to_m = 14e-6;

const BandRadiance& band() {
  static const BandRadiance made(from_m, to_m);
  return made;
}

/// Planck's law by small steps of wavelength (CODATA 2018), W/(m2 sr).
double by_steps(double from, double to, double temperature_k) {
  constexpr double h = 6.62607015e-34, c = 299792458, k = 1.380649e-23;
  constexpr int steps = 20000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double l = from + (i + 0.5) / steps * (to - from);
    sum += 2 * h * c * c / std::pow(l, 5) / std::expm1(h * c / (l * k * temperature_k)) *
           (to - from) / steps;
  }
  return sum;
}

TEST(BandRadiance, IsPlancksLawOverTheBand) {
  for (const double t : {200.0, 255.0, 288.15, 300.05, 353.0, 480.0}) {
    EXPECT_NEAR(BandRadiance::exact(from_m, to_m, t) / by_steps(from_m, to_m, t), 1, 1e-6) << t;
    EXPECT_NEAR(band().of(t) / BandRadiance::exact(from_m, to_m, t), 1, 1e-5) << t;
    EXPECT_NEAR(BandRadiance::exact(3e-6, 5e-6, t) / by_steps(3e-6, 5e-6, t), 1, 1e-6) << t;
  }
}

// From 1 um to a millimetre all but 1e-6 of sigma T^4/pi.
TEST(BandRadiance, OfAllWavelengthsIsStefansAndBoltzmanns) {
  for (const double t : {200.0, 300.0, 450.0})
    EXPECT_NEAR(BandRadiance::exact(1e-6, 1e-3, t) / (5.670374419e-8 * std::pow(t, 4) / pi), 1,
                2e-5);
}

TEST(BandRadiance, GoesBothWays) {
  for (double t = 150; t <= 500; t += 0.0371) {
    EXPECT_NEAR(band().temperature_k(band().of(t)), t, 1e-9);
  }
  EXPECT_EQ(band().temperature_k(0), 150);
  EXPECT_NEAR(band().slope(300), (by_steps(from_m, to_m, 300.5) - by_steps(from_m, to_m, 299.5)),
              1e-3);
}

Warmth calm_day() {
  Warmth warmth;
  warmth.air_k = 290;
  warmth.sky_overhead_k = 235;
  warmth.cloud_k = 280;
  warmth.attenuation_per_m = 0;
  for (SurfaceWarmth& one : warmth.surfaces) one = {305, 0, 1};
  warmth.surfaces[static_cast<std::size_t>(Material::water)] = {287, 0, 0.99};
  return warmth;
}

/// A thing of steel.
struct OfSteel : Cast {
  explicit OfSteel(TriangleMesh mesh) : Cast(std::move(mesh)) {
    scene.surface_m = 200;  // all of it is in air
    scene.things[0].material = Material::steel;
  }
};

SurfaceWarmth& steel_of(Warmth& warmth) {
  return warmth.surfaces[static_cast<std::size_t>(Material::steel)];
}

struct Look {
  Warmth warmth = calm_day();
  Sky sky;
  double beam_w_m2 = 0;
  bool is_overcast = false;
  double visible_per_m = 0;
  Shadows shadows;
  double netd_k = 0;

  [[nodiscard]] InfraredFrame at(const Cast& cast, const Pose& pose, int threads = 1,
                                 double wide_deg = 1, int wide = 5) const {
    const Pinhole camera(pose, frame_of(wide, wide, wide_deg));
    FrameHits hits;
    (void)truth_of(cast.scene, camera, 5000, threads, hits);
    return infrared_of(cast.scene, {warmth, sky, beam_w_m2, is_overcast, visible_per_m, shadows},
                       {from_m, to_m, netd_k}, camera, hits, 7, threads);
  }
};

const Pose& ahead() {
  static const Pose pose = looking({0, 0, 0}, {1, 0, 0});
  return pose;
}
Pose down_from(double height_m) { return looking({0, 0, -height_m}, {0, 0, 0}); }

TEST(Infrared, ABlackBodyHasItsTemperature) {
  const OfSteel cast(wall_mesh(5));
  Look look;
  for (const double t : {250.0, 288.0, 333.3}) {
    steel_of(look.warmth).temperature_k = t;
    const InfraredFrame seen = look.at(cast, ahead());
    for (std::size_t i = 0; i < 25; ++i) {
      EXPECT_NEAR(seen.apparent_k[i], t, 1e-4);
      EXPECT_NEAR(seen.temperature_k[i], t, 1e-4);
      EXPECT_NEAR(seen.radiance[i], BandRadiance::exact(from_m, to_m, t), 1e-3);
    }
  }
}

// e B(T) + (1 - e) S, with S of the whole sky over a level face, B(air)(1 - t^1.66), and half of it
// and half of the sea before an upright one.
TEST(Infrared, WhatIsNotBlackMirrorsTheSky) {
  Look look;
  const double b_air = band().of(290), left = 1 - band().of(235) / b_air;
  const double whole = b_air * (1 - std::pow(left, 1.66)), sea = band().of(287);
  for (const double e : {0.3, 0.8}) {
    steel_of(look.warmth) = {305, 0, e};
    const InfraredFrame level =
        look.at(OfSteel(level_mesh({-50, -50, 0}, 10, 10, 10)), down_from(5));
    EXPECT_NEAR(level.radiance[12], e * band().of(305) + (1 - e) * whole, 1e-4);
    const InfraredFrame upright = look.at(OfSteel(wall_mesh(5)), ahead());
    EXPECT_NEAR(upright.radiance[12], e * band().of(305) + (1 - e) * 0.5 * (whole + sea), 1e-4);
    EXPECT_NEAR(upright.apparent_k[12],
                band().temperature_k(static_cast<double>(upright.radiance[12])), 1e-3);
    look.is_overcast = true;
    const InfraredFrame cloudy =
        look.at(OfSteel(level_mesh({-50, -50, 0}, 10, 10, 10)), down_from(5));
    EXPECT_NEAR(cloudy.radiance[12], e * band().of(305) + (1 - e) * band().of(280), 1e-4);
    look.is_overcast = false;
  }
}

TEST(Infrared, TheSkyIsColdOverheadAndAsWarmAsTheAirOverTheHorizon) {
  const OfSteel cast(level_mesh({-50, -50, 100}, 10, 10, 10));
  const Look look;
  EXPECT_NEAR(look.at(cast, looking({0, 0, 0}, {1e-9, 0, -1})).apparent_k[12], 235, 0.02);
  const double left = 1 - band().of(235) / band().of(290);
  const InfraredFrame slant = look.at(cast, looking({0, 0, 0}, {1, 0, -std::tan(pi / 6)}));
  EXPECT_NEAR(slant.radiance[12], band().of(290) * (1 - left * left), 1e-3);
  EXPECT_TRUE(std::isnan(slant.temperature_k[12]));
  EXPECT_NEAR(look.at(cast, looking({0, 0, 0}, {1, 0, -1e-4})).apparent_k[12], 290, 0.1);
}

// All of one temperature, sky and air too, is seen at that temperature, whatever its emissivity,
// turn and range: the second law.
TEST(Infrared, WithinWallsOfOneTemperatureAllIsAsWarmAsTheyAre) {
  Look look;
  look.warmth.air_k = look.warmth.sky_overhead_k = look.warmth.cloud_k = 290;
  look.warmth.attenuation_per_m = 0.01;
  for (SurfaceWarmth& one : look.warmth.surfaces) one = {290, 0, 0.35};
  OfSteel cast(sphere_mesh(20, 6, 40));
  const InfraredFrame ball = look.at(cast, ahead(), 1, 60, 24);
  for (const float t : ball.apparent_k) EXPECT_NEAR(t, 290, 1e-3);
  cast.scene.things[0].seen_class = SeenClass::water;
  cast.scene.things[0].material = Material::water;
  const InfraredFrame sea = look.at(cast, ahead(), 1, 60, 24);
  for (const float t : sea.apparent_k) EXPECT_NEAR(t, 290, 1e-3);
}

TEST(Infrared, AirBetweenBringsItsOwnHeat) {
  Look look;
  look.warmth.attenuation_per_m = 2e-4;
  for (const double range_m : {10.0, 500.0, 2000.0}) {
    const double tau = std::exp(-2e-4 * range_m);
    const InfraredFrame seen = look.at(OfSteel(wall_mesh(range_m)), ahead(), 1, 0.1);
    EXPECT_NEAR(seen.radiance[12], tau * band().of(305) + (1 - tau) * band().of(290), 1e-4);
  }
  // Fog takes heat as it takes light, haze does not.
  look.visible_per_m = 2.9e-3;
  EXPECT_NEAR(look.at(OfSteel(wall_mesh(500)), ahead(), 1, 0.1).radiance[12],
              band().of(290) + std::exp(-0.1) * (band().of(305) - band().of(290)), 1e-4);
  look.visible_per_m = 6e-3;
  EXPECT_NEAR(look.at(OfSteel(wall_mesh(500)), ahead(), 1, 0.1).radiance[12],
              band().of(290) + std::exp(-3.1) * (band().of(305) - band().of(290)), 1e-4);
}

// By the cosine of the sun on the face and the share of a kW/m2; none in a shadow.
TEST(Infrared, TheSunWarmsWhatItShinesOn) {
  Look look;
  steel_of(look.warmth) = {290, 20, 1};
  look.beam_w_m2 = 700;
  look.sky.beam = 0.8;
  for (const double turned_deg : {0.0, 40.0, 75.0, 110.0}) {
    const double turn = turned_deg * constants::degree;
    look.sky.to_sun = {-std::cos(turn), std::sin(turn), 0};
    const double warmer = 20 * 0.7 * std::max(0.0, std::cos(turn));
    EXPECT_NEAR(look.at(OfSteel(wall_mesh(5)), ahead()).temperature_k[12], 290 + warmer, 1e-4);
  }
  look.sky.to_sun = unit({-1, 1, 0});
  const std::vector<TriangleMesh> post{cylinder_mesh({3, 2, -2}, 0.3, 4, 24, 1)};
  look.shadows.still = std::make_shared<const RayCaster>(post);
  EXPECT_NEAR(look.at(OfSteel(wall_mesh(5)), ahead()).temperature_k[12], 290, 1e-4);
}

// 0.99 of the sea squarely; flatly it mirrors one place of the sky, by Schlick.
TEST(Infrared, TheSeaMirrorsTheSkyFlatly) {
  OfSteel cast(level_mesh({-4000, -4000, 0}, 400, 20, 20));
  cast.scene.things[0].seen_class = SeenClass::water;
  cast.scene.things[0].material = Material::water;
  const Look look;
  const double left = 1 - band().of(235) / band().of(290);
  for (const double up_deg : {90.0, 40.0, 10.0}) {
    const double sine = std::sin(up_deg * constants::degree);
    const double away = 10 / std::tan(up_deg * constants::degree);
    const InfraredFrame seen = look.at(cast, looking({0, 0, -10}, {away + 1e-9, 0, 0}), 1, 0.01);
    const double e = 0.99 * (1 - std::pow(1 - sine, 5));
    EXPECT_NEAR(seen.emissivity[12], e, 1e-4) << up_deg;
    EXPECT_NEAR(seen.radiance[12],
                e * band().of(287) + (1 - e) * band().of(290) * (1 - std::pow(left, 1 / sine)),
                1e-3)
        << up_deg;
  }
}

TEST(Infrared, ItsNoiseIsItsNetd) {
  Look look;
  steel_of(look.warmth).temperature_k = 300;
  look.netd_k = 0.08;
  const InfraredFrame seen = look.at(OfSteel(wall_mesh(5)), ahead(), 1, 20, 64);
  double squares = 0, sum = 0;
  for (const float t : seen.apparent_k) {
    squares += (t - 300.0) * (t - 300.0) / 4096;
    sum += (t - 300.0) / 4096;
  }
  EXPECT_NEAR(std::sqrt(squares), 0.08, 4 * 0.08 / std::sqrt(2.0 * 4096) + 2e-4);
  EXPECT_NEAR(sum, 0, 4 * 0.08 / 64);
}

TEST(Infrared, IsTheSameOnAnyNumberOfThreads) {
  Look look;
  look.netd_k = 0.05;
  const OfSteel cast(sphere_mesh(20, 6, 40));
  const InfraredFrame one = look.at(cast, ahead(), 1, 60, 48);
  for (const int threads : {2, 5})
    EXPECT_EQ(one.apparent_k, look.at(cast, ahead(), threads, 60, 48).apparent_k);
}

TEST(Warmth, EveryFileOfTheFolderIsOneAndABadOneIsOneClearError) {
  const auto data = slackwater::tests::source_folder() / "data";
  std::size_t read = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data / "warmth")) {
    const Warmth warmth = read_named_warmth(entry.path().stem().string(), data);
    EXPECT_FALSE(warmth.source.empty());
    EXPECT_LT(warmth.sky_overhead_k, warmth.air_k);
    ++read;
  }
  EXPECT_GE(read, 2U);
  const auto said = [](const std::string& yaml) -> std::string {
    try {
      (void)read_warmth(Config::parse("name: t\nsource: t\nstatus: estimate\n" + yaml, "t.yaml"));
    } catch (const Error& problem) {
      return problem.message();
    }
    return "";
  };
  EXPECT_NE(said("air_c: 10\nsky_overhead_c: 12\ncloud_c: 5\nattenuation_per_km: 0\n")
                .find("is warmer than air_c"),
            std::string::npos);
  EXPECT_NE(said("air_c: 10\nsky_overhead_c: -40\ncloud_c: 5\nattenuation_per_km: 0.2\n"
                 "surfaces: {steel: {temperature_c: 10, emissivity: 2}}\n")
                .find("yellow_paint"),
            std::string::npos);
}

}  // namespace
}  // namespace slackwater::twin::infrared_test
