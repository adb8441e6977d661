// Light and contrast under water against their laws, and against the veil added up in small steps.
#include "twin/inspection/instrument/seen_light.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"
#include "twin/inspection/instrument/clarity.h"
#include "twin/inspection/instrument/quality.h"

namespace slackwater::twin::seen_light_test {
namespace {

Instrument camera(double lamp_range_m, double lamp_aside_m = 0.2) {
  Instrument made;
  made.kind = InstrumentKind::rgb;
  made.footprint = FrameFootprint{1, 1, 1000, 1000, 0.01};
  made.most_range_m = 1000;
  made.needs_light = true;
  made.lamp_range_m = lamp_range_m;
  made.lamp_aside_m = lamp_aside_m;
  return made;
}
Clarity night(double c, double backscatter_per_m = 0) { return {c, 0, 0, backscatter_per_m}; }
/// Contrast times light: by what the detail grows.
double shown(const SeenLight& seen) { return seen.contrast * seen.light; }

// To the place and back: exp(-c (r_l + r)) / r^2.
TEST(SeenLight, OfALampFallsByTheSquareAndByTheWayThereAndBack) {
  const Instrument lamp = camera(2, 0);
  for (const double c : {0.0, 0.3, 1.1})
    for (const double r : {2.5, 4.0, 9.0}) {
      const SeenLight seen = seen_light(lamp, night(c), 20, r);
      EXPECT_NEAR(shown(seen), 4 / (r * r) * std::exp(-2 * c * r), 1e-15) << c << " " << r;
      EXPECT_NEAR(shown(seen_light(lamp, night(c), 20, 2 * r)) / shown(seen),
                  std::exp(-2 * c * r) / 4, 1e-15);
      EXPECT_EQ(seen.contrast, 1) << "no veil without backscatter";
    }
  // One far aside: its own way, and its light at an angle.
  const double r = 3, h = 4;
  EXPECT_NEAR(shown(seen_light(camera(2, h), night(0.5), 20, r)),
              4.0 / 25 * 3 / 5 * std::exp(-0.5 * (5 + 3)), 1e-15);
}

TEST(SeenLight, OfTheDayAloneIsBeersAndItsVeilIsAsBrightAsThePlace) {
  const Clarity clarity{0.6, 0.8, 0.15, 0.009};
  for (const double r : {0.5, 2.0, 6.0}) {
    const SeenLight seen = seen_light(camera(0), clarity, 7, r);
    EXPECT_NEAR(seen.light, 0.8 * std::exp(-0.15 * 7), 1e-15);
    EXPECT_NEAR(seen.contrast, std::exp(-0.6 * r), 1e-15);
  }
  // More than enough: the camera stops down, and the contrast is what it was.
  const Clarity bright{0.6, 100, 0.15, 0.009};
  EXPECT_EQ(seen_light(camera(0), bright, 7, 2).light, 1);
  EXPECT_NEAR(seen_light(camera(0), bright, 7, 2).contrast, std::exp(-1.2), 1e-15);
}

double veil_in_steps(double c, double h, double r) {
  constexpr int steps = 20000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double s = r * (i + 0.5) / steps, from_lamp = std::sqrt(s * s + h * h);
    sum += s / std::pow(from_lamp, 3) * std::exp(-c * (s + from_lamp));
  }
  return sum * r / steps;
}

TEST(LampVeil, IsWhatTheLampLightsOfTheWaterAddedUp) {
  for (const double h : {0.1, 0.2, 1.0})
    for (const double r : {0.3, 1.5, 5.0}) {
      const double clear = 1 / h - 1 / std::hypot(r, h);
      EXPECT_NEAR(lamp_veil_per_m(0, h, r), clear, 1e-4 * clear) << "exact in clear water";
      for (const double c : {0.2, 1.0, 4.0}) {
        const double added = veil_in_steps(c, h, r);
        EXPECT_NEAR(lamp_veil_per_m(c, h, r), added, 3e-4 * added) << c << " " << h << " " << r;
      }
    }
}

TEST(LampVeil, IsLessOfALampFartherAside) {
  for (double h = 0.1; h < 2; h *= 1.5)
    EXPECT_LT(lamp_veil_per_m(0.5, 1.5 * h, 3), lamp_veil_per_m(0.5, h, 3));
}

TEST(SeenLight, ContrastOfALampIsThatOfThePlaceAndTheWaterTogether) {
  const double c = 0.5, b = 0.0075, r = 1.8, h = 0.25, from_lamp = std::hypot(r, h);
  const SeenLight seen = seen_light(camera(2, h), night(c, b), 20, r);
  // By radiances: a lamp of candle power I, a place of 0.1 / pi, water of b / 2 pi.
  const double place =
      0.1 / constants::pi * r / std::pow(from_lamp, 3) * std::exp(-c * (from_lamp + r));
  const double water = b / (2 * constants::pi) * veil_in_steps(c, h, r);
  EXPECT_NEAR(seen.contrast, place / (place + water), 2e-4);
  // What is needed is what a place at 2 m throws back in clear water.
  EXPECT_NEAR(seen.light, (place + water) / (0.1 / constants::pi / 4), 2e-4);
  EXPECT_LT(seen.light, 1);
}

TEST(SeenLight, ShowsLessTheDirtierTheWaterAndTheFartherThePlace) {
  Rng rng(11, "test/seen_light");
  for (int i = 0; i < 500; ++i) {
    const Instrument lamp = camera(rng.uniform(0.5, 4), rng.uniform(0.05, 1));
    const double c = rng.uniform(0.05, 3), r = rng.uniform(0.3, 6), more = rng.uniform(1.05, 2);
    const auto dark = [&](double attenuation) { return night(attenuation, 0.015 * attenuation); };
    EXPECT_LT(shown(seen_light(lamp, dark(more * c), 20, r)),
              shown(seen_light(lamp, dark(c), 20, r)));
    EXPECT_LT(shown(seen_light(lamp, dark(c), 20, more * r)),
              shown(seen_light(lamp, dark(c), 20, r)));
    EXPECT_LT(seen_light(lamp, night(c, 0.03 * c), 20, r).contrast,
              seen_light(lamp, night(c, 0.01 * c), 20, r).contrast);
  }
}

// By day in murk a lamp may hide more than it shows; then it is off.
TEST(SeenLight, ALampIsOnlyOnWhereItHelps) {
  const Clarity murk{2, 100, 0, 0.03};
  const SeenLight with = seen_light(camera(50), murk, 3, 2),
                  without = seen_light(camera(0), murk, 3, 2);
  EXPECT_EQ(with.contrast, without.contrast);
  EXPECT_EQ(with.light, without.light);
  Rng rng(12, "test/seen_light");
  for (int i = 0; i < 500; ++i) {
    const double c = rng.uniform(0.05, 3), r = rng.uniform(0.3, 6);
    const Clarity day{c, rng.uniform(0, 3), c / 4, 0.015 * c};
    EXPECT_GE(shown(seen_light(camera(2), day, 10, r)), shown(seen_light(camera(0), day, 10, r)));
  }
}

// LiDAR brings its own light and gates the rest; infrared sees what shines by itself.
TEST(SeenLight, OfLidarGoesThereAndBack) {
  Instrument other = camera(0);
  other.needs_light = false;
  const Clarity haze{0.01, 0, 0, 0};
  EXPECT_NEAR(seen_light(other, haze, -20, 30).contrast, std::exp(-0.3), 1e-15);
  other.kind = InstrumentKind::lidar;
  EXPECT_NEAR(seen_light(other, haze, -20, 30).contrast, std::exp(-0.6), 1e-15);
  other.kind = InstrumentKind::multibeam;
  EXPECT_EQ(seen_light(other, haze, 20, 30).contrast, 1);
}

// At the visibility of a black disc the contrast is the one at which it is lost: no look counts
// beyond.
TEST(SeenLight, NoLookCountsBeyondTheVisibilityOfABlackDisc) {
  const double visibility_m = 7;
  const Clarity clarity{beam_attenuation_of_water(visibility_m), 1, 0, 0};
  EXPECT_NEAR(seen_light(camera(0), clarity, 5, visibility_m).contrast, std::exp(-4.8), 1e-15);
  const Pose pose{{0, 0, 5}, {1, 0, 0}, {0, 1, 0}, {}, {}};
  const auto is_seen = [&](const Instrument& instrument, double range_m) {
    return quality_of(instrument, pose, clarity, {range_m, 0, 5}, {-1, 0, 0}).has_value();
  };
  EXPECT_TRUE(is_seen(camera(0), visibility_m));
  EXPECT_FALSE(is_seen(camera(0), 1.001 * visibility_m));
  Instrument sonar = camera(0);
  sonar.kind = InstrumentKind::multibeam;
  EXPECT_TRUE(is_seen(sonar, 10 * visibility_m));
}

}  // namespace
}  // namespace slackwater::twin::seen_light_test
