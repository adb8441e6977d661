// What sensors tell, byte by byte. Expected numbers are worked out by hand.
#include <Eigen/Geometry>
#include <cmath>

#include "api/door/dds/message/detection_messages.h"
#include "api/door/dds/message/sensor_messages.h"
#include "api/door/dds/message/sonar_messages.h"
#include "fields/base/numbers/random.h"
#include "tests/api/door/dds/cdr_by_hand.h"

namespace slackwater::dds::sensor_bytes_test {
namespace {

using tests::HandReader;
using tests::hex;

const SensorStamp of{{10, 20}, "rov/rov_camera"};

TEST(BytesOfSensors, CameraInfoCountsFromTheMiddleOfTheFirstPixel) {
  // 64 degrees over 640 pixels: 320 / tan(32 degrees) = 512.107; the middle is (320, 180) from the
  // corner.
  const double f = 320 / std::tan(32 * std::acos(-1.0) / 180);
  HandReader read(camera_info(640, 360, {f, 0, 320, 0, f, 180, 0, 0, 1}, of));
  read.expect_header(of.stamp, "rov/rov_camera");
  EXPECT_EQ(read.count(), 360U);
  EXPECT_EQ(read.count(), 640U);
  EXPECT_EQ(read.string(), "plumb_bob");
  EXPECT_EQ(read.count(), 5U);
  EXPECT_EQ(read.reals(5), std::vector<double>(5, 0.0));
  EXPECT_NEAR(f, 512.107, 5e-4);
  EXPECT_EQ(read.reals(9), (std::vector<double>{f, 0, 319.5, 0, f, 179.5, 0, 0, 1}));
  EXPECT_EQ(read.reals(9), (std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1}));
  EXPECT_EQ(read.reals(12), (std::vector<double>{f, 0, 319.5, 0, 0, f, 179.5, 0, 0, 0, 1, 0}));
  EXPECT_EQ(read.count(), 0U);  // binning_x
  EXPECT_EQ(read.count(), 0U);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(read.count(), 0U) << "no region of its own";
  EXPECT_EQ(read.octet(), 0);  // do_rectify
  read.expect_end();
}

TEST(BytesOfSensors, CompressedImageByteByByte) {
  const std::vector<std::uint8_t> jpeg{0xFF, 0xD8, 0xFF};
  EXPECT_EQ(compressed_image(jpeg, {{1, 500'000'000}, "r"}),
            hex("00 01 00 00  01 00 00 00  00 65 CD 1D  02 00 00 00 72 00 00 00"
                "05 00 00 00 6A 70 65 67 00 00 00 00  03 00 00 00  FF D8 FF"));
}

TEST(BytesOfSensors, DetectionsHaveTheirBoxesByTheirMiddles) {
  const std::vector<FoundBox> found{{"crack", 0.75, 10, 20, 40, 30}};
  HandReader read(detections_message(found, of));
  read.expect_header(of.stamp, "rov/rov_camera");
  ASSERT_EQ(read.count(), 1U);
  read.expect_header(of.stamp, "rov/rov_camera");
  ASSERT_EQ(read.count(), 1U);
  EXPECT_EQ(read.string(), "crack");
  EXPECT_EQ(read.real(), 0.75);
  EXPECT_EQ(read.reals(7), (std::vector<double>{0, 0, 0, 0, 0, 0, 1}));
  EXPECT_EQ(read.reals(36), std::vector<double>(36, 0.0));
  // From 10 to 40 the middle is 25 from the corner, 24.5 from the middle of the first pixel.
  EXPECT_EQ(read.reals(3), (std::vector<double>{24.5, 24.5, 0}));
  EXPECT_EQ(read.reals(2), (std::vector<double>{30, 10}));
  EXPECT_EQ(read.string(), "");
  read.expect_end();
  HandReader nothing(detections_message({}, of));
  nothing.expect_header(of.stamp, "rov/rov_camera");
  EXPECT_EQ(nothing.count(), 0U);
  nothing.expect_end();
}

TEST(BytesOfSensors, DepthIsRowsOfSinglePrecision) {
  twin::TruthFrame truth;
  truth.wide = 2;
  truth.high = 3;
  truth.depth_m = {1.5F, 2.5F, NAN, 3.5F, 0.25F, NAN};
  HandReader read(depth_image(truth, of));
  read.expect_header(of.stamp, "rov/rov_camera");
  EXPECT_EQ(read.count(), 3U);  // height
  EXPECT_EQ(read.count(), 2U);
  EXPECT_EQ(read.string(), "32FC1");
  EXPECT_EQ(read.octet(), 0);   // little endian
  EXPECT_EQ(read.count(), 8U);  // bytes a row
  EXPECT_EQ(read.count(), 24U);
  for (const float depth : truth.depth_m) {
    const float told = read.real32();
    EXPECT_TRUE(told == depth || (std::isnan(told) && std::isnan(depth)));
  }
  read.expect_end();
}

/// Two channels, level and 30 degrees up, at four bearings clockwise: ahead, to starboard, astern,
/// to port. Forward is x, left y, up z.
TEST(BytesOfSensors, CloudIsForwardLeftUp) {
  twin::LidarSheet sheet;
  sheet.channels = 2;
  sheet.columns = 4;
  sheet.lowest_rad = 0;
  sheet.highest_rad = std::acos(-1.0) / 6;
  twin::LidarScan scan;
  scan.channels = 2;
  scan.columns = 4;
  scan.range_m = {1, 2, 4, 8, 16, 32, NAN, 64};
  scan.intensity = {1, 2, 3, 4, 5, 6, 7, 8};
  HandReader read(point_cloud(scan, sheet, of));
  read.expect_header(of.stamp, "rov/rov_camera");
  EXPECT_EQ(read.count(), 2U);
  EXPECT_EQ(read.count(), 4U);
  ASSERT_EQ(read.count(), 4U);
  std::uint32_t offset = 0;
  for (const char* name : {"x", "y", "z", "intensity"}) {
    EXPECT_EQ(read.string(), name);
    EXPECT_EQ(read.count(), offset);
    EXPECT_EQ(read.octet(), 7) << "FLOAT32";
    EXPECT_EQ(read.count(), 1U);
    offset += 4;
  }
  EXPECT_EQ(read.octet(), 0);  // little endian
  EXPECT_EQ(read.count(), 16U);
  EXPECT_EQ(read.count(), 64U);
  EXPECT_EQ(read.count(), 128U);
  const double c = std::sqrt(0.75);
  const double expected[8][3] = {{1, 0, 0},       {0, -2, 0},     {-4, 0, 0},
                                 {0, 8, 0},       {16 * c, 0, 8}, {0, -32 * c, 16},
                                 {NAN, NAN, NAN}, {0, 64 * c, 32}};
  for (std::size_t i = 0; i < 8; ++i) {
    for (const double number : expected[i]) {
      const double told = read.real32();
      if (std::isnan(number)) {
        EXPECT_TRUE(std::isnan(told)) << i;
      } else {
        EXPECT_NEAR(told, number, 64 * 1e-7) << i;  // of single precision
      }
    }
    EXPECT_EQ(read.real32(), scan.intensity[i]);
  }
  EXPECT_EQ(read.octet(), 0) << "not dense: some are no numbers";
  read.expect_end();
}

TEST(BytesOfSensors, PingIsRowsOfRangeFromPortToStarboard) {
  twin::ImagingSonarSheet sheet;
  sheet.beams = 3;
  sheet.across_rad = std::acos(-1.0) / 3;  // 30 degrees to port, ahead, 30 to starboard
  sheet.beam_rad = 0.25;
  sheet.upright_rad = 0.5;
  sheet.frequency_hz = 750e3;
  twin::SonarImage image;
  image.beams = 3;
  image.bins = 2;
  image.intensity = {1, 2, 3, 4, 5, 6};  // beam by beam
  HandReader read(sonar_image(image, sheet, 10, of));
  read.expect_header(of.stamp, "rov/rov_camera");
  EXPECT_EQ(read.real32(), 750e3F);
  EXPECT_EQ(read.real32(), 0);  // speed of sound: unknown
  EXPECT_EQ(read.count(), 3U);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(read.real32(), 0.5F);
  EXPECT_EQ(read.count(), 3U);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(read.real32(), 0.25F);
  ASSERT_EQ(read.count(), 3U);
  for (const double side : {-0.5, 0.0, 0.5}) {  // x up, y to starboard, z ahead
    EXPECT_EQ(read.real(), 0);
    EXPECT_NEAR(read.real(), side, 1e-15);
    EXPECT_NEAR(read.real(), std::sqrt(1 - side * side), 1e-15);
  }
  ASSERT_EQ(read.count(), 2U);
  EXPECT_EQ(read.real32(), 2.5F);  // middles of 0 to 5 and 5 to 10 m
  EXPECT_EQ(read.real32(), 7.5F);
  EXPECT_EQ(read.octet(), 0);
  EXPECT_EQ(read.count(), 8U);  // DTYPE_FLOAT32
  EXPECT_EQ(read.count(), 3U);
  EXPECT_EQ(read.count(), 24U);
  for (const float number : {1.F, 3.F, 5.F, 2.F, 4.F, 6.F}) EXPECT_EQ(read.real32(), number);
  read.expect_end();
}

/// The right one of a pair, 12 cm from the left one: P(0, 3) = -f baseline.
TEST(BytesOfSensors, RightCameraOfAPairSaysItsBaseline) {
  HandReader read(camera_info(640, 360, {500, 0, 320, 0, 500, 180, 0, 0, 1}, of, 0.12));
  read.expect_header(of.stamp, "rov/rov_camera");
  (void)read.count();
  (void)read.count();
  (void)read.string();
  (void)read.reals(read.count());
  (void)read.reals(18);
  EXPECT_EQ(read.reals(12),
            (std::vector<double>{500, 0, 319.5, -60, 0, 500, 179.5, 0, 0, 0, 1, 0}));
}

TEST(BytesOfSensors, HeatIsRowsOfKelvins) {
  twin::InfraredFrame heat;
  heat.wide = 3;
  heat.high = 1;
  heat.apparent_k = {280.5F, 281, 230};
  HandReader read(heat_image(heat, of));
  read.expect_header(of.stamp, "rov/rov_camera");
  EXPECT_EQ(read.count(), 1U);
  EXPECT_EQ(read.count(), 3U);
  EXPECT_EQ(read.string(), "32FC1");
  EXPECT_EQ(read.octet(), 0);
  EXPECT_EQ(read.count(), 12U);
  EXPECT_EQ(read.count(), 12U);
  for (const float kelvins : heat.apparent_k) EXPECT_EQ(read.real32(), kelvins);
  read.expect_end();
}

/// 30 degrees below the plane of forward and starboard, to port and then to starboard: x is up.
TEST(BytesOfSensors, SideScanIsTwoColumnsFromPort) {
  twin::SideScanSheet sheet;
  sheet.depression_rad = std::acos(-1.0) / 6;
  sheet.beam_rad = 0.25;
  sheet.upright_rad = 0.5;
  twin::SideScanPing ping;
  ping.bins = 3;
  ping.bin_m = 2;
  ping.intensity = {1, 2, 3, 4, 5, 6};  // port from near to far, then starboard
  HandReader read(side_scan_image(ping, sheet, of));
  read.expect_header(of.stamp, "rov/rov_camera");
  EXPECT_EQ(read.real32(), 0) << "frequency: unknown";
  EXPECT_EQ(read.real32(), 0) << "speed of sound: unknown";
  for (const float width : {0.25F, 0.5F}) {  // along the track, across
    ASSERT_EQ(read.count(), 2U);
    for (int side = 0; side < 2; ++side) EXPECT_EQ(read.real32(), width);
  }
  ASSERT_EQ(read.count(), 2U);
  for (const double side : {-1.0, 1.0}) {
    EXPECT_NEAR(read.real(), -0.5, 1e-15);
    EXPECT_NEAR(read.real(), side * std::sqrt(0.75), 1e-15);
    EXPECT_EQ(read.real(), 0);
  }
  ASSERT_EQ(read.count(), 3U);
  for (const float middle : {1.F, 3.F, 5.F}) EXPECT_EQ(read.real32(), middle);
  EXPECT_EQ(read.octet(), 0);
  EXPECT_EQ(read.count(), 8U);  // DTYPE_FLOAT32
  EXPECT_EQ(read.count(), 2U);
  EXPECT_EQ(read.count(), 24U);
  for (const float number : {1.F, 4.F, 2.F, 5.F, 3.F, 6.F}) EXPECT_EQ(read.real32(), number);
  read.expect_end();
}

TEST(BytesOfSensors, RangesOfAFanWithTheBeamThatHeardNothing) {
  twin::MultibeamSheet sheet;
  sheet.beam_across_rad = 0.25;
  sheet.beam_along_rad = 0.5;
  std::vector<twin::Sounding> soundings(2);
  soundings[0].bearing_rad = -std::acos(-1.0) / 6;
  soundings[0].range_m = 12.5F;
  soundings[0].level = 2;
  soundings[1].bearing_rad = std::acos(-1.0) / 6;
  soundings[1].range_m = NAN;
  HandReader read(sonar_ranges(soundings, sheet, of));
  read.expect_header(of.stamp, "rov/rov_camera");
  EXPECT_EQ(read.real32(), 0);
  EXPECT_EQ(read.real32(), 0);
  for (const float width : {0.5F, 0.25F}) {
    ASSERT_EQ(read.count(), 2U);
    for (int beam = 0; beam < 2; ++beam) EXPECT_EQ(read.real32(), width);
  }
  ASSERT_EQ(read.count(), 2U);
  EXPECT_EQ(read.octet(), 0) << "DETECT_OK";
  EXPECT_EQ(read.octet(), 1) << "DETECT_BAD_SONAR";
  EXPECT_EQ(read.count(), 0U) << "no delays";
  ASSERT_EQ(read.count(), 2U);
  EXPECT_EQ(read.real32(), 2);
  EXPECT_EQ(read.real32(), 0);
  ASSERT_EQ(read.count(), 2U);
  for (const double side : {-0.5, 0.5}) {
    EXPECT_EQ(read.real(), 0);
    EXPECT_NEAR(read.real(), side, 1e-15);
    EXPECT_NEAR(read.real(), std::sqrt(0.75), 1e-15);
  }
  ASSERT_EQ(read.count(), 2U);
  EXPECT_EQ(read.real32(), 12.5F);
  EXPECT_TRUE(std::isnan(read.real32()));
  read.expect_end();
}

/// 10 m with a noise of 0.01 m and half a percent: 0.06 m, a variance of 0.0036 m2.
TEST(BytesOfSensors, RangeSaysItsVarianceAndInfinityWithoutABottom) {
  twin::EchoSounderSheet sheet;
  sheet.beam_rad = 0.5;
  sheet.noise_sd_m = 0.01;
  sheet.noise_per_range = 0.005;
  twin::EchoSounding sounding;
  for (const float range_m : {10.F, NAN}) {
    sounding.range_m = range_m;
    HandReader read(range_message(sounding, sheet, {0.25, 64}, of));
    read.expect_header(of.stamp, "rov/rov_camera");
    EXPECT_EQ(read.octet(), 0) << "ULTRASOUND";
    EXPECT_EQ(read.real32(), 0.5F);
    EXPECT_EQ(read.real32(), 0.25F);
    EXPECT_EQ(read.real32(), 64);
    const bool is_told = range_m == 10;
    EXPECT_EQ(read.real32(), is_told ? 10 : INFINITY);
    EXPECT_NEAR(read.real32(), is_told ? 0.0036 : 0, 1e-9);
    read.expect_end();
  }
}

/// North 0.5, east 0.25, 0.125 down: up is -0.125.
TEST(BytesOfSensors, CurrentsAreBinsAlongTheAxis) {
  twin::CurrentProfile profile;
  profile.bins.resize(2);
  profile.bins[0].distance_m = 2;
  profile.bins[0].velocity_m_s = {0.5, 0.25, 0.125};
  profile.bins[1].distance_m = 3;
  profile.bins[1].velocity_m_s = {NAN, NAN, NAN};
  HandReader read(current_cloud(profile, of));
  read.expect_header(of.stamp, "rov/rov_camera");
  EXPECT_EQ(read.count(), 1U);
  EXPECT_EQ(read.count(), 2U);
  ASSERT_EQ(read.count(), 6U);
  std::uint32_t offset = 0;
  for (const char* name : {"x", "y", "z", "east", "north", "up"}) {
    EXPECT_EQ(read.string(), name);
    EXPECT_EQ(read.count(), offset);
    EXPECT_EQ(read.octet(), 7) << "FLOAT32";
    EXPECT_EQ(read.count(), 1U);
    offset += 4;
  }
  EXPECT_EQ(read.octet(), 0);
  EXPECT_EQ(read.count(), 24U);
  EXPECT_EQ(read.count(), 48U);
  ASSERT_EQ(read.count(), 48U);
  for (const float number : {2.F, 0.F, 0.F, 0.25F, 0.5F, -0.125F, 3.F, 0.F, 0.F})
    EXPECT_EQ(read.real32(), number);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(std::isnan(read.real32()));
  EXPECT_EQ(read.octet(), 0) << "not dense";
  read.expect_end();
}

Eigen::Vector3d enu(const twin::Triple<double>& ned) { return {ned.y, ned.x, -ned.z}; }

/// By Eigen: the quaternion turns x, y and z of the sensor's frame to where they lie in ENU,
/// whichever of its four is the largest.
TEST(BytesOfSensors, PoseTurnsTheFrameOfEachKindToItsPlace) {
  Rng rng(7, "sensor_bytes_test");
  const auto unit = [&] {
    const Eigen::Vector3d v(rng.normal(), rng.normal(), rng.normal());
    return v.normalized().eval();
  };
  for (int i = 0; i < 200; ++i) {
    Eigen::Vector3d axis = unit(), right = axis.cross(unit()).normalized();
    if (i < 6) {  // along the axes of the world, down among them
      axis = Eigen::Vector3d::Zero();
      axis[i / 2] = i % 2 == 0 ? 1 : -1;
      right = axis.cross(Eigen::Vector3d(axis.y(), axis.z(), axis.x())).normalized();
    }
    twin::Pose pose;
    pose.position_m = {1, 2, 3};
    pose.axis = {axis.x(), axis.y(), axis.z()};
    pose.right = {right.x(), right.y(), right.z()};
    const Eigen::Vector3d ahead = enu(pose.axis), aside = enu(pose.right),
                          below = enu(cross(pose.axis, pose.right));
    const std::tuple<SensorAxes, Eigen::Vector3d, Eigen::Vector3d, Eigen::Vector3d> kinds[] = {
        {SensorAxes::camera, aside, below, ahead},
        {SensorAxes::scanner, ahead, -aside, -below},
        {SensorAxes::fan, -below, aside, ahead}};
    for (const auto& [kind, x, y, z] : kinds) {
      HandReader read(sensor_pose(pose, kind, {10, 20}));
      read.expect_header({10, 20}, "map");
      EXPECT_EQ(read.reals(3), (std::vector<double>{2, 1, -3}));
      const std::vector<double> q = read.reals(4);
      EXPECT_GE(q[3], 0);
      const Eigen::Matrix3d turned = Eigen::Quaterniond(q[3], q[0], q[1], q[2]).toRotationMatrix();
      EXPECT_LT((turned.col(0) - x).norm(), 1e-12) << i;
      EXPECT_LT((turned.col(1) - y).norm(), 1e-12) << i;
      EXPECT_LT((turned.col(2) - z).norm(), 1e-12) << i;
      read.expect_end();
    }
  }
}

}  // namespace
}  // namespace slackwater::dds::sensor_bytes_test
