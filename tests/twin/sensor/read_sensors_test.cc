#include "twin/sensor/read_sensors.h"

#include <gtest/gtest.h>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "tests/support/shared_data.h"

namespace slackwater::twin::read_sensors_test {
namespace {

Sensors read(const std::string& yaml) {
  const Config config = Config::parse(yaml, "made-up.yaml");
  Sensors sensors = read_sensors(config);
  config.expect_all_read();
  return sensors;
}

testing::AssertionResult refused(const std::string& sensor, const std::string& why) {
  try {
    (void)read("sensors: {" + sensor + "}");
  } catch (const Error& problem) {
    if (problem.kind() == ErrorKind::invalid_input &&
        problem.message().find(why) != std::string::npos)
      return testing::AssertionSuccess();
    return testing::AssertionFailure() << "not '" << why << "' in: " << problem.message();
  }
  return testing::AssertionFailure() << sensor << " was taken";
}

TEST(ReadSensors, GivesWhatIsCarriedAndNothingElse) {
  const Sensors none = read("{}");
  EXPECT_FALSE(none.gnss || none.imu || none.depth || none.compass || none.dvl || none.adcp ||
               none.sonar || none.camera);
  const Sensors some = read(R"(sensors:
  gnss: {}
  dvl: {slant_deg: 22.5, farthest_m: 80}
  camera: {tilt_deg: 30, visibility_m: 2, position_m: [0.2, 0, 0.05]}
)");
  EXPECT_EQ(some.gnss->white_horizontal_sd_m, Gnss{}.white_horizontal_sd_m);
  EXPECT_NEAR(some.dvl->slant_rad, 22.5 * constants::pi / 180, 1e-15);
  EXPECT_EQ(some.dvl->farthest_m, 80);
  EXPECT_EQ(some.camera->position_m.x, 0.2);
  EXPECT_NEAR(some.camera->tilt_rad, constants::pi / 6, 1e-15);
  EXPECT_FALSE(some.adcp);
}

TEST(ReadSensors, ReachesEveryValueOfEverySensor) {
  const Sensors s = read(R"(sensors:
  gnss: {white_horizontal_sd_m: 1, white_vertical_sd_m: 2, slow_horizontal_sd_m: 3,
         slow_vertical_sd_m: 4, correlation_time_s: 5, velocity_sd_m_s: 6, reacquisition_s: 7}
  imu: {gyro_white_rad_s_rthz: 0.01, gyro_walk_rad_s_rts: 0.002, gyro_start_bias_sd_rad_s: 0.03,
        gyro_range_rad_s: 4,
        accelerometer_white_m_s2_rthz: 0.05, accelerometer_walk_m_s2_rts: 0.06,
        accelerometer_start_bias_sd_m_s2: 0.07, accelerometer_range_m_s2: 80}
  depth: {scale: 1.01, offset_m: 0.2, noise_sd_m: 0.3, resolution_m: 0.4, deepest_m: 50}
  compass: {constant_deg: 1, sine_deg: 2, cosine_deg: 3, double_sine_deg: 4, double_cosine_deg: 5,
            declination_error_deg: 6, noise_sd_deg: 7}
  adcp: {slant_deg: 25, azimuth_deg: 10, looks_up: false, bin_m: 2, blanking_m: 3, bins: 4,
         pings: 5, noise_sd_m_s: 0.6, ambiguity_m_s: 7}
  sonar: {sector_deg: 90, beams: 9, tilt_deg: 10, nearest_m: 1, farthest_m: 20,
          least_squareness: 0.3, noise_sd_m: 0.4, resolution_m: 0.5}
)");
  EXPECT_EQ(s.gnss->slow_vertical_m.sd, 4);
  EXPECT_EQ(s.gnss->slow_vertical_m.correlation_time_s, 5);
  EXPECT_EQ(s.imu->gyro.walk_density, 0.002);
  EXPECT_EQ(s.imu->accelerometer.range, 80);
  EXPECT_EQ(s.depth->deepest_m, 50);
  EXPECT_NEAR(s.compass->double_cosine_rad, 5 * constants::pi / 180, 1e-15);
  EXPECT_FALSE(s.adcp->looks_up);
  EXPECT_EQ(s.adcp->pings, 5);
  EXPECT_EQ(s.sonar->beams, 9);
  EXPECT_EQ(s.sonar->resolution_m, 0.5);
}

TEST(ReadSensors, RefusesWhatNoSensorCanBeAndSaysWhy) {
  EXPECT_TRUE(refused("gnss: {white_horizontal_sd_m: -1}", "white_horizontal_sd_m"));
  EXPECT_TRUE(refused("gnss: {correlation_time_s: 0}", "correlation_time_s"));
  EXPECT_TRUE(refused("dvl: {farthest_m: 2, nearest_m: 3}", "not beyond nearest_m"));
  EXPECT_TRUE(refused("dvl: {layer_near_m: 5}", "not beyond layer_near_m"));
  EXPECT_TRUE(refused("dvl: {least_squareness: 0.9}", "no beam"));
  EXPECT_TRUE(refused("sonar: {farthest_m: 0.5}", "not beyond nearest_m"));
  EXPECT_TRUE(refused("compass: {sine_deg: 45, cosine_deg: 45}", "show alike"));
  EXPECT_TRUE(refused("camera: {horizontal_field_deg: 180}", "horizontal_field_deg"));
  EXPECT_TRUE(refused("camera: {position_m: [1]}", "[x, y, z]"));
  EXPECT_TRUE(refused("adcp: {bins: 0}", "bins"));
  EXPECT_TRUE(refused("depth: {scale: .nan}", "scale"));
  EXPECT_TRUE(refused("gnss: {rate_hz: 0}", "rate_hz"));
  EXPECT_TRUE(refused("dlv: {}", "dvl"));
}

TEST(ReadSensors, TheBundledVehiclesCarryWhatTheyNavigateBy) {
  const auto sensors_of = [](const char* id) {
    return read_sensors(
        Config::load(tests::source_folder() / "data/vehicles" / (std::string(id) + ".yaml")));
  };
  const Sensors rov = sensors_of("bluerov2_heavy");
  EXPECT_TRUE(rov.imu && rov.depth && rov.compass && rov.dvl && rov.sonar && rov.camera);
  EXPECT_FALSE(rov.gnss);
  const Sensors auv = sensors_of("lrauv_tethys");
  EXPECT_TRUE(auv.gnss && auv.depth && auv.dvl && auv.compass && auv.imu);
  const Sensors uav = sensors_of("x500");
  EXPECT_TRUE(uav.gnss && uav.imu && uav.compass && uav.camera);
  EXPECT_FALSE(uav.depth);
  for (const char* craft : {"wamv16", "ctv24"}) {
    const Sensors afloat = sensors_of(craft);
    EXPECT_TRUE(afloat.gnss && afloat.imu && afloat.compass) << craft;
  }
}

}  // namespace
}  // namespace slackwater::twin::read_sensors_test
