#include <cmath>

#include "tests/api/door/dds/cdr_by_hand.h"
#include "tests/api/door/dds/vehicle_for_tests.h"

// What vehicles tell, byte by byte. Expected numbers are worked out by hand from NED and body
// (forward, right, down) to ENU and body (forward, left, up).

namespace slackwater::dds::vehicle_bytes_test {
namespace {

using tests::HandReader;
using tests::hex;
using tests::VehicleForTests;

void expect_zeros(const std::vector<double>& numbers) {
  for (const double number : numbers) EXPECT_EQ(number, 0);
}

TEST(BytesOfVehicles, HeaderIsTheTwentyBytesOfTheRules) {
  const VehicleForTests rov;
  const Bytes message = pose(rov.state, {1, 500'000'000});
  const Bytes header = hex("00 01 00 00  01 00 00 00  00 65 CD 1D  04 00 00 00  6D 61 70 00");
  ASSERT_EQ(message.size(), 20 + 7 * 8);  // the first number of eight lies at 16 already
  EXPECT_TRUE(std::equal(header.begin(), header.end(), message.begin()));
}

TEST(BytesOfVehicles, OdometryIsPoseInMapAndVelocityInTheBody) {
  const VehicleForTests rov;
  HandReader read(odometry(rov.agent, rov.state, rov.name, rov.stamp));
  read.expect_header(rov.stamp, "map");
  EXPECT_EQ(read.string(), "rov/base_link");
  EXPECT_EQ(read.reals(3), (std::vector<double>{4, 3, -5}));
  // Body to NED (1/2, 1/2, 1/2, 1/2) carries forward to east, right to down and down to north: left
  // is then up and up south. That is a roll of a quarter about an axis that stays where it is.
  const std::vector<double> q = read.reals(4);  // x, y, z, w
  EXPECT_NEAR(q[0], std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(q[1], 0, 1e-15);
  EXPECT_NEAR(q[2], 0, 1e-15);
  EXPECT_NEAR(q[3], std::sqrt(0.5), 1e-15);
  expect_zeros(read.reals(36));
  EXPECT_EQ(read.reals(3), (std::vector<double>{1.5, -0.25, 0.5}));
  EXPECT_EQ(read.reals(3), (std::vector<double>{0.125, -0.5, 0.25}));
  expect_zeros(read.reals(36));
  read.expect_end();
}

TEST(BytesOfVehicles, OdometryIsWhatTheVehicleTakesForTrue) {
  VehicleForTests rov;
  rov.agent.navigation->steers = true;
  HandReader read(odometry(rov.agent, rov.state, rov.name, rov.stamp));
  read.expect_header(rov.stamp, "map");
  (void)read.string();
  EXPECT_EQ(read.reals(3), (std::vector<double>{40, 30, -50}));
  HandReader truth(pose(rov.state, rov.stamp));
  truth.expect_header(rov.stamp, "map");
  EXPECT_EQ(truth.reals(3), (std::vector<double>{4, 3, -5}));
}

TEST(BytesOfVehicles, BatteryFieldsStandInTheOrderOfRos) {
  const VehicleForTests rov;
  HandReader read(battery_state(rov.agent, rov.state, rov.name, rov.stamp));
  read.expect_header(rov.stamp, "rov/base_link");
  EXPECT_EQ(read.real32(), 15.5F);         // voltage
  EXPECT_TRUE(std::isnan(read.real32()));  // temperature
  EXPECT_EQ(read.real32(), -8.25F);        // current: negative, it discharges
  EXPECT_EQ(read.real32(), 12.0F);         // charge, Ah
  EXPECT_EQ(read.real32(), 16.0F);         // capacity
  EXPECT_EQ(read.real32(), 16.0F);         // design_capacity
  EXPECT_EQ(read.real32(), 0.75F);         // percentage, 0 to 1
  EXPECT_EQ(read.octet(), 2);              // discharging
  EXPECT_EQ(read.octet(), 1);              // good
  EXPECT_EQ(read.octet(), 2);              // li-ion
  EXPECT_EQ(read.octet(), 1);              // present
  EXPECT_EQ(read.count(), 0U);             // cell_voltage
  EXPECT_EQ(read.count(), 0U);             // cell_temperature
  EXPECT_EQ(read.string(), "hull");        // location
  EXPECT_EQ(read.string(), "");            // serial_number: a NUL alone
  read.expect_end();
}

TEST(BytesOfVehicles, BatteryByteByByte) {
  const VehicleForTests rov;
  EXPECT_EQ(battery_state(rov.agent, rov.state, "r", {1, 500'000'000}),
            hex("00 01 00 00  01 00 00 00  00 65 CD 1D"
                "0C 00 00 00  72 2F 62 61 73 65 5F 6C 69 6E 6B 00"  // r/base_link
                "00 00 78 41  00 00 C0 7F  00 00 04 C1  00 00 40 41"
                "00 00 80 41  00 00 80 41  00 00 40 3F  02 01 02 01"
                "00 00 00 00  00 00 00 00  05 00 00 00  68 75 6C 6C 00 00 00 00"
                "01 00 00 00  00"));
}

TEST(BytesOfVehicles, StatusOfTheBatteryFollowsWhatItDoes) {
  VehicleForTests rov;
  EXPECT_EQ(battery_status(rov.state), 2);  // discharging
  rov.state.vehicle.current_a = 0;
  EXPECT_EQ(battery_status(rov.state), 3);  // neither
  rov.state.vehicle.battery.charge = 1;
  EXPECT_EQ(battery_status(rov.state), 4);  // full
  rov.state.vehicle.battery.off = 1;
  rov.state.vehicle.current_a = 8;
  EXPECT_EQ(battery_status(rov.state), 3);
}

TEST(BytesOfVehicles, WithoutABatteryNothingIsMeasured) {
  VehicleForTests usv;
  auto vehicle = std::make_shared<twin::Vehicle>(*usv.agent.vehicle);
  vehicle->battery.reset();
  usv.agent.vehicle = vehicle;
  HandReader read(battery_state(usv.agent, usv.state, usv.name, usv.stamp));
  read.expect_header(usv.stamp, "rov/base_link");
  for (int i = 0; i < 7; ++i) EXPECT_TRUE(std::isnan(read.real32())) << i;
  for (int i = 0; i < 3; ++i) EXPECT_EQ(read.octet(), 0) << i;
  EXPECT_EQ(read.octet(), 0) << "not present";
}

TEST(BytesOfVehicles, ImuIsForwardLeftUp) {
  VehicleForTests rov;
  twin::Shown& shown = rov.state.navigation.instruments.shown;
  shown.turn_rate_rad_s = {0.5, 0.25, 0.125};
  shown.specific_force_m_s2 = {1, 2, -9.75};
  HandReader read(imu(rov.agent, rov.state, rov.name, rov.stamp));
  read.expect_header(rov.stamp, "rov/base_link");
  const std::vector<double> q = read.reals(4);  // what it makes of it: level, heading north
  EXPECT_NEAR(q[2], std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(q[3], std::sqrt(0.5), 1e-15);
  expect_zeros(read.reals(9));  // unknown
  EXPECT_EQ(read.reals(3), (std::vector<double>{0.5, -0.25, -0.125}));
  EXPECT_EQ(read.reals(9), (std::vector<double>{0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5}));
  EXPECT_EQ(read.reals(3), (std::vector<double>{1, -2, 9.75}));  // at rest and level: +g up
  EXPECT_EQ(read.reals(9), (std::vector<double>{2, 0, 0, 0, 2, 0, 0, 0, 2}));
  read.expect_end();
}

TEST(BytesOfVehicles, FixIsOnTheEllipsoidAndSaysItsStatus) {
  VehicleForTests rov;
  const GeoPoint origin = GeoPoint::from_degrees(48.5, -2.5);
  rov.state.navigation.instruments.shown.gnss_position_m = {111'000, 0, -2};
  HandReader read(nav_sat_fix(rov.state, origin, 50, rov.name, rov.stamp));
  read.expect_header(rov.stamp, "rov/base_link");
  EXPECT_EQ(read.get<std::int8_t>(), 0);     // fix
  EXPECT_EQ(read.get<std::uint16_t>(), 1U);  // GPS, at the next even byte
  EXPECT_EQ(read.offset() % 2, 0U);
  EXPECT_NEAR(read.real(), 49.5, 0.003);  // a degree is 111.2 km there (WGS 84)
  EXPECT_EQ(read.real(), -2.5);
  EXPECT_EQ(read.real(), 52);  // 2 m above the geoid, which is 50 m above the ellipsoid
  const std::vector<double> covariance = read.reals(9);
  EXPECT_GT(covariance[0], 0);
  EXPECT_EQ(covariance[0], covariance[4]);
  EXPECT_GT(covariance[8], covariance[0]);
  EXPECT_EQ(read.octet(), 1);  // approximated
  read.expect_end();
}

TEST(BytesOfVehicles, WithoutAFixThereIsNoNumber) {
  const VehicleForTests rov;
  HandReader read(
      nav_sat_fix(rov.state, GeoPoint::from_degrees(48.5, -2.5), 50, rov.name, rov.stamp));
  read.expect_header(rov.stamp, "rov/base_link");
  EXPECT_EQ(read.get<std::int8_t>(), -1);
  EXPECT_EQ(read.get<std::uint16_t>(), 1U);
  for (const double number : read.reals(3)) EXPECT_TRUE(std::isnan(number));
  expect_zeros(read.reals(9));
  EXPECT_EQ(read.octet(), 0);  // unknown
}

TEST(BytesOfVehicles, PressureIsAbsolute) {
  VehicleForTests rov;
  rov.state.navigation.instruments.shown.depth_m = 10;
  HandReader read(fluid_pressure(rov.state, 1025, rov.name, rov.stamp));
  read.expect_header(rov.stamp, "rov/base_link");
  EXPECT_NEAR(read.real(), 101'325 + 1025 * 9.80665 * 10, 1e-6);
  EXPECT_EQ(read.real(), 0);  // variance: unknown
  read.expect_end();
}

TEST(BytesOfVehicles, VelocityWithCovarianceLiesOnEights) {
  VehicleForTests rov;
  twin::Shown& shown = rov.state.navigation.instruments.shown;
  shown.dvl_velocity_m_s = {1, 0.5, -0.25};
  shown.dvl_is_bottom = 1;
  shown.dvl_ahead_m_s = 1.25;
  // Names of each length mod 8: the first number must be moved to the next multiple of eight.
  for (const std::string name : {"", "a", "ab", "abc", "abcd", "abcde", "abcdef", "abcdefg"}) {
    const Bytes message = dvl(rov.agent, rov.state, name, rov.stamp);
    const std::size_t text_end = 8 + 4 + name.size() + std::string("/base_link").size() + 1;
    EXPECT_EQ(message.size(), 4 + (text_end + 7) / 8 * 8 + 42 * 8) << name;
    HandReader read(message);
    read.expect_header(rov.stamp, name + "/base_link");
    EXPECT_EQ(read.reals(6), (std::vector<double>{1, -0.5, 0.25, 0, 0, 0}));
    for (int row = 0; row < 6; ++row)
      for (int column = 0; column < 6; ++column)
        EXPECT_EQ(read.real(), row != column ? 0 : row < 3 ? 0.0625 : -1) << row << column;
    read.expect_end();
  }
}

TEST(BytesOfVehicles, DvlTellsWhatItHeard) {
  VehicleForTests rov;
  twin::Shown& shown = rov.state.navigation.instruments.shown;
  const auto velocity = [&](const Bytes& message) {
    HandReader read(message);
    read.expect_header(rov.stamp, "rov/base_link");
    return read.reals(3);
  };
  const auto over_ground = [&] { return velocity(dvl(rov.agent, rov.state, "rov", rov.stamp)); };
  const auto through = [&] { return velocity(dvl_water(rov.agent, rov.state, "rov", rov.stamp)); };
  shown.dvl_velocity_m_s = {1, 0.5, -0.25};
  shown.dvl_ahead_m_s = 1.25;
  shown.dvl_is_bottom = 1;
  EXPECT_EQ(over_ground(), (std::vector<double>{1, -0.5, 0.25}));
  EXPECT_EQ(through()[0], 1.25);
  EXPECT_TRUE(std::isnan(through()[1]) && std::isnan(through()[2]));
  shown.dvl_is_bottom = 0;
  for (const double number : over_ground()) EXPECT_TRUE(std::isnan(number));
  EXPECT_EQ(through(), (std::vector<double>{1, -0.5, 0.25}));
}

TEST(BytesOfVehicles, ReserveIsThreeNumbersAndAdvice) {
  HandReader read(reserve({1e6, 4e5, 900, "come home by 10:40"}, "rov", {10, 20}));
  read.expect_header({10, 20}, "rov/base_link");
  EXPECT_EQ(read.reals(3), (std::vector<double>{1e6, 4e5, 900}));
  EXPECT_EQ(read.string(), "come home by 10:40");
  read.expect_end();
}

TEST(BytesOfVehicles, PathRepeatsItsHeaderInEachPlace) {
  const std::vector<twin::Waypoint> waypoints{{{1, 2, 3}, 0, 0}, {{10, 20, 30}, 0, 0}};
  HandReader read(active_waypoints(waypoints, {10, 20}));
  read.expect_header({10, 20}, "map");
  EXPECT_EQ(read.count(), 2U);
  for (const double scale : {1, 10}) {
    read.expect_header({10, 20}, "map");
    EXPECT_EQ(read.reals(3), (std::vector<double>{2 * scale, scale, -3 * scale}));
    EXPECT_EQ(read.reals(4), (std::vector<double>{0, 0, 0, 1}));
  }
  read.expect_end();
  EXPECT_EQ(active_waypoints({}, {1, 500'000'000}),
            hex("00 01 00 00  01 00 00 00  00 65 CD 1D  04 00 00 00  6D 61 70 00  00 00 00 00"));
}

TEST(BytesOfVehicles, TextIsLengthWithItsEnd) {
  EXPECT_EQ(text("ok"), hex("00 01 00 00  03 00 00 00  6F 6B 00"));
  EXPECT_EQ(text(""), hex("00 01 00 00  01 00 00 00  00"));
}

}  // namespace
}  // namespace slackwater::dds::vehicle_bytes_test
