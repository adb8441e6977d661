#include "twin/render/light/sun_glint.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"

namespace slackwater::twin::sun_glint_test {
namespace {

const Triple<double> up{0, 0, -1};

/// At an angle off the zenith, towards an azimuth.
Triple<double> towards(double off_rad, double azimuth_rad = 0) {
  return {std::sin(off_rad) * std::cos(azimuth_rad), std::sin(off_rad) * std::sin(azimuth_rad),
          -std::cos(off_rad)};
}

TEST(SunGlint, FresnelIsSchlicks) {
  EXPECT_NEAR(mirrored_share(1), 0.02, 1e-12);
  EXPECT_NEAR(mirrored_share(0), 1, 1e-12);
  // Unpolarised, index 1.34, at 60 degrees: Fresnel's own 0.060; Schlick's is known to be a little
  // off there.
  EXPECT_NEAR(mirrored_share(0.5), 0.060, 0.012);
}

/// Under a sun in the zenith a facet is as large before the sun as on the level, so that all that
/// comes back is what a face mirrors: 2 %, whatever the slopes.
TEST(SunGlint, NoLightIsMadeAndNoneIsLost) {
  for (const double slope : {0.005, 0.02}) {
    constexpr int rings = 4000;
    double sum = 0;
    for (int i = 0; i < rings; ++i) {
      const double off = (i + 0.5) * 0.45 * constants::pi / rings;
      sum += 2 * constants::pi * std::sin(off) * std::cos(off) *
             sun_glint_per_sr(towards(off), up, up, slope) * 0.45 * constants::pi / rings;
    }
    EXPECT_NEAR(sum, 0.02, 0.0002) << slope;
  }
}

TEST(SunGlint, IsBrightestWhereAMirrorWouldShowTheSun) {
  const Triple<double> sun = towards(0.5);
  double most = 0, at = 0;
  for (double off = -1.2; off < 1.2; off += 0.001) {
    const double glint = sun_glint_per_sr(towards(off), sun, up, 0.003);
    if (glint <= most) continue;
    most = glint;
    at = off;
  }
  EXPECT_NEAR(at, -0.5, 0.02);
  // There beta is 0, and the formula is F / (pi s2) / (4 cos theta).
  EXPECT_NEAR(sun_glint_per_sr(towards(-0.5), sun, up, 0.003),
              mirrored_share(std::cos(0.5)) / (constants::pi * 0.003) / (4 * std::cos(0.5)), 1e-9);
}

TEST(SunGlint, OfASunBelowTheFaceThereIsNone) {
  EXPECT_EQ(sun_glint_per_sr(towards(0.3), towards(1.7), up, 0.03), 0);
}

}  // namespace
}  // namespace slackwater::twin::sun_glint_test
