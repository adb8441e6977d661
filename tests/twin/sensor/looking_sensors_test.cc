// Sonar and camera against structures, bed and surface.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fields/base/constants.h"
#include "twin/body/attitude.h"
#include "twin/sensor/camera.h"
#include "twin/sensor/range_sonar.h"

namespace slackwater::twin::looking_sensors_test {
namespace {

using constants::pi;

const Rotation<double> level = rotation_of(Attitude<double>{1, 0, 0, 0});
const std::vector<Structure> pile{Cylinder{20, 0, 4, -10, 30}};
const Scene at_the_pile{pile, 30, 0};

double length(const Triple<double>& v) { return std::sqrt(dot(v, v)); }

RangeSonar exact_sonar() {
  RangeSonar sonar;
  sonar.noise_sd_m = 0;
  sonar.resolution_m = 0;
  sonar.least_squareness = 0;
  return sonar;
}

/// From the distance D to the axis, at the bearing b: D cos b - sqrt(R^2 - D^2 sin^2 b).
TEST(RangeSonars, SeeAPileAsACircle) {
  NoiseStream noise(1, "rov/sonar");
  int heard = 0;
  for (const SonarEcho& echo : measured(exact_sonar(), noise, at_the_pile, {0, 0, 15}, level)) {
    const double aside = 20 * std::sin(echo.bearing_rad);
    EXPECT_EQ(echo.range_m.has_value(), std::abs(aside) < 4) << echo.bearing_rad;
    if (!echo.range_m) continue;
    ++heard;
    EXPECT_NEAR(*echo.range_m, 20 * std::cos(echo.bearing_rad) - std::sqrt(16 - aside * aside),
                1e-12);
  }
  EXPECT_EQ(heard, 12);  // asin(1/5) = 11.54 degrees to both sides, in beams of 2
}

TEST(RangeSonars, DropWhatIsTooNearTooFarOrTooSlantwise) {
  NoiseStream noise(1, "rov/sonar");
  RangeSonar sonar = exact_sonar();
  const auto heard = [&](double north_m) {
    int n = 0;
    for (const auto& echo : measured(sonar, noise, at_the_pile, {north_m, 0, 15}, level))
      n += echo.range_m.has_value();
    return n;
  };
  EXPECT_GT(heard(15.2), 0);
  EXPECT_EQ(heard(-40), 0);
  sonar.beams = 1;
  EXPECT_EQ(heard(15.2), 1);
  EXPECT_EQ(heard(15.26), 0);
  sonar.beams = 60;
  const int all = heard(0);
  sonar.least_squareness = 0.9;
  EXPECT_LT(heard(0), all);
}

TEST(RangeSonars, AreAsNoisyAsStated) {
  NoiseStream noise(2, "rov/sonar");
  RangeSonar sonar = exact_sonar();
  sonar.beams = 1;
  sonar.noise_sd_m = 0.1;
  constexpr int n = 20000;
  double sum = 0, squares = 0;
  for (int i = 0; i < n; ++i) {
    const double off = *measured(sonar, noise, at_the_pile, {0, 0, 15}, level)[0].range_m - 16;
    sum += off / n;
    squares += off * off / n;
  }
  EXPECT_NEAR(sum, 0, 5 * 0.1 / std::sqrt(n));
  EXPECT_NEAR(squares, 0.01, 5 * 0.01 * std::sqrt(2.0 / n));
  sonar.resolution_m = 0.25;
  const double coarse = *measured(sonar, noise, at_the_pile, {0, 0, 15}, level)[0].range_m;
  EXPECT_NEAR(4 * coarse, std::round(4 * coarse), 1e-12);
}

Camera square_on() {
  Camera camera;
  camera.visibility_m = 100;
  return camera;
}

double area_of(const std::vector<Triple<double>>& polygon) {
  Triple<double> sum;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sum = sum + cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
  return 0.5 * length(sum);
}

TEST(Cameras, LookingStraightDownShowARectangleOfTheBed) {
  Camera camera = square_on();
  camera.tilt_rad = pi / 2;
  camera.horizontal_field_rad = 2 * std::atan(0.5);  // as wide as it is far
  const Footprint seen = footprint(camera, {{}, 30, 0}, {1, 2, 26}, level, 1);
  ASSERT_TRUE(seen.whole && seen.centre);
  ASSERT_EQ(seen.outline_m.size(), 4U);
  EXPECT_NEAR(area_of(seen.outline_m), 4 * (4 * 1080.0 / 1920), 1e-9);
  EXPECT_NEAR(seen.centre->range_m, 4, 1e-12);
  EXPECT_NEAR(seen.centre->squareness, 1, 1e-12);
  EXPECT_NEAR(seen.centre->pixel_size_m, 4.0 / 1920, 1e-12);
  // The upper edge of the picture lies ahead, its right to starboard.
  EXPECT_NEAR(seen.outline_m[0].x, 1 + 2 * 1080.0 / 1920, 1e-9);
  EXPECT_NEAR(seen.outline_m[1].y, 2 + 2, 1e-9);
}

TEST(Cameras, ASlantedLookShowsATrapezium) {
  Camera camera = square_on();
  camera.tilt_rad = pi / 4;
  camera.horizontal_field_rad = 2 * std::atan(0.5);
  const Footprint seen = footprint(camera, {{}, 30, 0}, {0, 0, 26}, level, 1);
  ASSERT_TRUE(seen.whole);
  EXPECT_NEAR(seen.centre->range_m, 4 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(seen.centre->squareness, std::sqrt(0.5), 1e-12);
  const double half = std::atan(0.5 * 1080 / 1920);
  EXPECT_NEAR(seen.outline_m[0].x, 4 / std::tan(pi / 4 - half), 1e-9);
  EXPECT_NEAR(seen.outline_m[3].x, 4 / std::tan(pi / 4 + half), 1e-9);
}

/// On a cylinder by its own closed form: from D before the axis, at the angle b aside, the wall
/// lies at the angle about the axis where the sine law puts it.
TEST(Cameras, WrapTheirPictureAroundAPile) {
  const Camera camera = square_on();
  const Triple<double> at{14.5, 0, 15};
  const Footprint seen = footprint(camera, at_the_pile, at, level, 16);
  ASSERT_TRUE(seen.whole);
  EXPECT_EQ(seen.outline_m.size(), 64U);
  for (const auto& p : seen.outline_m) EXPECT_NEAR(std::hypot(p.x - 20, p.y), 4, 1e-9);
  const double b = camera.horizontal_field_rad / 2;
  const auto edge = sighting(camera, at_the_pile, at, level, 1920, 540);
  const double incidence = std::asin(5.5 / 4 * std::sin(b));
  EXPECT_NEAR(edge->squareness, std::cos(incidence), 1e-9);
  EXPECT_NEAR(std::atan2(edge->at_m.y, 20 - edge->at_m.x), incidence - b, 1e-9);
}

TEST(Cameras, APixelIsNoLargerThanItIsSaidToBe) {
  Camera camera = square_on();
  camera.tilt_rad = 0.3;
  const Rotation<double> r = rotation_of(attitude_of({0.1, -0.2, 0.05}));
  const Triple<double> at{15, 0.5, 15};
  for (const double u : {100.0, 960.0, 1500.0}) {
    for (const double v : {50.0, 540.0, 1000.0}) {
      const auto seen = sighting(camera, at_the_pile, at, r, u, v);
      ASSERT_TRUE(seen);
      double widest = 0;
      for (int k = 0; k < 16; ++k) {
        const double turn = pi * k / 16;
        const auto a = sighting(camera, at_the_pile, at, r, u + 0.5 * std::cos(turn),
                                v + 0.5 * std::sin(turn));
        const auto b = sighting(camera, at_the_pile, at, r, u - 0.5 * std::cos(turn),
                                v - 0.5 * std::sin(turn));
        widest = std::max(widest, length(a->at_m - b->at_m));
      }
      EXPECT_LT(widest, seen->pixel_size_m * 1.001) << u << ", " << v;
      EXPECT_GT(widest, seen->pixel_size_m * 0.7) << u << ", " << v;
    }
  }
}

TEST(Cameras, SeeNothingBeyondTheVisibilityAndSaySo) {
  Camera camera;
  camera.visibility_m = 3;
  EXPECT_FALSE(footprint(camera, at_the_pile, {10, 0, 15}, level, 4).centre);
  // Near enough for the middle, too far for the edges.
  const Footprint part = footprint(camera, at_the_pile, {13.1, 0, 15}, level, 4);
  EXPECT_TRUE(part.centre);
  EXPECT_FALSE(part.whole);
}

}  // namespace
}  // namespace slackwater::twin::looking_sensors_test
