#include "twin/render/sheet/render_sensor.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "tests/support/shared_data.h"
#include "tests/twin/render/render_for_tests.h"
#include "twin/render/frame/pinhole.h"
#include "twin/sensor/camera.h"

namespace slackwater::twin::render_sensor_test {
namespace {

const std::filesystem::path& data() {
  static const std::filesystem::path folder = slackwater::tests::source_folder() / "data";
  return folder;
}

/// What is said of a camera whose line of that key is another one.
std::string said_of(const std::string& key, const std::string& line) {
  std::string yaml = R"(name: test
source: test
status: estimate
kind: camera
medium: water
range_m: [0.1, 10]
frame: {horizontal_deg: 60, pixels_wide: 64, pixels_high: 48, exposure_s: 0.01}
)";
  const auto at = yaml.find(key + ":");
  if (at == std::string::npos)
    yaml += line + "\n";
  else
    yaml.replace(at, yaml.find('\n', at) - at, line);
  try {
    (void)read_render_sensor(Config::parse(yaml, "test.yaml"));
  } catch (const Error& problem) {
    return problem.message();
  }
  return "";
}

TEST(RenderSensor, EveryFileOfTheFolderIsOne) {
  std::size_t read = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data() / "sensors")) {
    const RenderSensor sensor = read_named_render_sensor(entry.path().stem().string(), data());
    EXPECT_FALSE(sensor.source.empty()) << entry.path();
    EXPECT_NEAR(length_of(sensor.axis), 1, 1e-12) << entry.path();
    ++read;
  }
  EXPECT_GE(read, 13U);
  for (const auto& entry : std::filesystem::directory_iterator(data() / "waters")) {
    const WaterType type = read_named_water_type(entry.path().stem().string(), data());
    EXPECT_FALSE(type.source.empty()) << entry.path();
    // Red goes first in all of them but the coast's, whose blue does.
    EXPECT_GT(std::max(type.diffuse_attenuation_per_m[0], type.diffuse_attenuation_per_m[2]),
              type.diffuse_attenuation_per_m[green])
        << entry.path();
  }
}

TEST(RenderSensor, WhatCannotBeIsOneClearError) {
  EXPECT_EQ(said_of("name", "name: test"), "");
  const auto expect = [](const std::string& said, const std::string& part) {
    EXPECT_NE(said.find(part), std::string::npos) << said;
  };
  expect(said_of("kind", "kind: camara"), "found camara (did you mean 'camera'?), expected camera");
  expect(said_of("medium", "medium: wter"), "expected water, air or both");
  expect(said_of("range_m", "range_m: [10, 0.1]"), "the lesser first");
  expect(said_of("axis", "axis: [0, 0, 0]"), "points nowhere");
  expect(said_of("zoom", "zoom: 3"), "zoom");
  expect(said_of("frame",
                 "frame: {horizontal_deg: 190, pixels_wide: 64, pixels_high: 48, exposure_s: 0}"),
         "horizontal_deg");
  expect(said_of("frame",
                 "frame: {horizontal_deg: 160, pixels_wide: 64, pixels_high: 640, exposure_s: 0}"),
         "which no pinhole sees");
  expect(said_of("frame",
                 "frame: {horizontal_deg: 60, vertical_deg: 2, pixels_wide: 64, "
                 "pixels_high: 48, exposure_s: 0}"),
         "leave it out for square ones");
  expect(said_of("marine_snow",
                 "marine_snow: {per_m3: 1e5, diameter_mm: 1, reflectance: 0.3, nearest_m: 0.1, "
                 "reach_m: 10}"),
         "flakes a picture, expected 1000000 at most");
  expect(said_of("marine_snow",
                 "marine_snow: {per_m3: 1, diameter_mm: 1, reflectance: 0.3, nearest_m: 3, "
                 "reach_m: 2}"),
         "expected more than nearest_m");
  expect(said_of("spray", "spray: {per_m3: 1e5, diameter_mm: 1, nearest_m: 0.1, reach_m: 10}"),
         "drops a picture, expected 1000000 at most");
  expect(said_of("spray", "spray: {per_m3: 1, diameter_mm: 1, nearest_m: 3, reach_m: 2}"),
         "no drops would be seen");
  expect(said_of("shutter", "shutter: {line_time_s: 1}"), "line_time_s");
  expect(said_of("stereo", "stereo: {baseline_m: 0}"), "baseline_m");
  expect(said_of("lamps", "lamps: [{position_m: [0, 0], range_m: 2, beam_deg: 100}]"),
         "expected three");
  EXPECT_THROW((void)read_named_render_sensor("no_such", data()), Error);
}

/// What is said of a file.
std::string said_of_file(const std::string& yaml) {
  try {
    (void)read_render_sensor(
        Config::parse("name: test\nsource: test\nstatus: estimate\n" + yaml, "test.yaml"));
  } catch (const Error& problem) {
    return problem.message();
  }
  return "";
}

TEST(RenderSensor, OfSoundOrHeatThatCannotBeIsOneClearError) {
  const auto expect = [](const std::string& yaml, const std::string& part) {
    EXPECT_NE(said_of_file(yaml).find(part), std::string::npos) << said_of_file(yaml);
  };
  const std::string adcp =
      "kind: adcp\nmedium: water\naxis: [0, 0, 1]\nrange_m: [1, 40]\nadcp: {bins: 30, bin_m: 1";
  EXPECT_EQ(said_of_file(adcp + "}\n"), "");
  expect(adcp + ", looks_up: true}\n", "is said by `axis`");
  // 0.9 m of blanking and 41 bins are 41.9 m, and 44.6 along a beam at 20 degrees.
  expect("kind: adcp\nmedium: water\nrange_m: [1, 40]\nadcp: {bins: 40, bin_m: 1}\n",
         "found up to 40 m, expected 44.6 m or more");
  const std::string side_scan =
      "kind: side_scan\nrange_m: [1, 50]\nside_scan: {beam_deg: 0.3, upright_deg: 50, "
      "depression_deg: 35, bins: 100, absorption_db_m: 0.3}\nmedium: ";
  EXPECT_EQ(said_of_file(side_scan + "water\n"), "");
  const std::string infrared =
      "kind: infrared\nmedium: air\nrange_m: [1, 50]\nframe: {horizontal_deg: 45, pixels_wide: "
      "64, pixels_high: 48, exposure_s: 0.01}\ninfrared: {netd_k: 0.05, band_um: ";
  EXPECT_EQ(said_of_file(infrared + "[8, 14]}\n"), "");
  expect(infrared + "[14, 8]}\n", "the shorter first");
  expect(side_scan + "air\n", "found air; a sensor of the kind side_scan works in water alone");
  expect("kind: multibeam\nmedium: water\nrange_m: [1, 50]\nmultibeam: {beams: 1}\n", "beams");
  expect("kind: echo_sounder\nmedium: water\nrange_m: [1, 50]\n", "echo_sounder");
  expect("kind: echosounder\nmedium: water\nrange_m: [1, 50]\n", "did you mean 'echo_sounder'?");
}

TEST(RenderSensor, OutsideItsMediumIsOneClearError) {
  const RenderSensor camera = read_named_render_sensor("rov_camera", data());
  EXPECT_NO_THROW(expect_in_medium(camera, true, "there"));
  try {
    expect_in_medium(camera, false, "2 m above the surface");
    FAIL();
  } catch (const Error& problem) {
    EXPECT_EQ(problem.message(),
              "Camera of a small ROV: found it in air at 2 m above the surface, expected it in "
              "water; take another time or vehicle, or a sensor of that medium");
  }
}

// One convention: the camera of twin/sensor looks along the same rays.
TEST(Pinhole, LooksAsTheVehiclesCameraDoes) {
  Camera camera;
  camera.pixels_wide = 64;
  camera.pixels_high = 48;
  camera.horizontal_field_rad = 60 * constants::degree;
  camera.tilt_rad = 0.3;
  camera.position_m = {0.2, 0.1, -0.05};
  camera.visibility_m = 1e6;
  RenderSensor sensor;
  sensor.position_m = camera.position_m;
  sensor.axis = {std::cos(0.3), 0, std::sin(0.3)};
  const EulerAngles turned{0.1, -0.05, 0.7};
  const Rotation<double> attitude = rotation_of(attitude_of(turned));
  const Carriage carriage{{3, -2, 5}, attitude, {}, {}};
  const Pinhole pinhole(pose_of(sensor, carriage), frame_of(64, 48, 60));
  Scene scene;
  scene.bed_m = 30;
  scene.surface_m = -1000;
  std::size_t met = 0;
  for (int j = 0; j < 48; j += 5)
    for (int i = 0; i < 64; i += 7) {
      const auto seen = sighting(camera, scene, carriage.position_m, attitude, i + 0.5, j + 0.5);
      const Ray ray = pinhole.ray(i, j);
      if (ray.direction.z <= 0) continue;
      const auto hit = hit_of_level(30, ray);
      ASSERT_EQ(seen.has_value(), hit.has_value());
      if (!seen) continue;
      EXPECT_NEAR(seen->range_m, hit->range_m, 1e-8 * hit->range_m);
      ++met;
    }
  EXPECT_GT(met, 20U);
}

TEST(Pinhole, MatrixIsThatOfItsPlaces) {
  const Pinhole pinhole(looking({0, 0, 0}, {1, 0, 0}), frame_of(64, 48, 60));
  const auto k = pinhole.matrix();
  const auto place = pinhole.place_of({4, 1, -0.5});
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->u, k[0] * 1 / 4 + k[2], 1e-12);
  EXPECT_NEAR(place->v, k[4] * -0.5 / 4 + k[5], 1e-12);
  EXPECT_NEAR(k[0], 32 / std::tan(30 * constants::degree), 1e-12);
  EXPECT_FALSE(pinhole.place_of({-1, 0, 0}));
}

}  // namespace
}  // namespace slackwater::twin::render_sensor_test
