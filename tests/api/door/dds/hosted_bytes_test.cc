#include "api/door/dds/message/hosted.h"

#include <cmath>

#include "tests/api/door/dds/cdr_by_hand.h"
#include "tests/api/door/dds/vehicle_for_tests.h"

// The protocol with processes that host an agent or physics, byte by byte.

namespace slackwater::dds::hosted_bytes_test {
namespace {

using tests::HandReader;
using tests::HandWriter;
using tests::hex;
using tests::Order;
using tests::VehicleForTests;

TEST(BytesOfTheHosted, AnswerNamesTheRequestAndTheVersion) {
  EXPECT_EQ(host_answer(7, true, "ok", 0.25),
            hex("00 01 00 00  07 00 00 00 00 00 00 00  01 00 00 00  03 00 00 00  6F 6B 00 00"
                "01 00 00 00  00 00 00 00 00 00 D0 3F"));
}

TEST(BytesOfTheHosted, ObservationIsWhatTheVehicleKnows) {
  VehicleForTests rov;
  HandReader read(agent_observation(rov.agent, rov.state, 12, rov.name, rov.stamp));
  read.expect_header(rov.stamp, "rov/base_link");
  EXPECT_EQ(read.get<std::uint64_t>(), 12U);
  EXPECT_EQ(read.reals(3), (std::vector<double>{4, 3, -5}));
  (void)read.reals(4);
  EXPECT_EQ(read.reals(6), (std::vector<double>{1.5, -0.25, 0.5, 0.125, -0.5, 0.25}));
  EXPECT_EQ(read.real(), 0.75);
  EXPECT_EQ(read.real(), 15.5);
  (void)read.real();  // altitude
  EXPECT_NE(read.string(), "");
  read.expect_end();
}

TEST(BytesOfTheHosted, PhysicsAreToldPlaceActuatorsAndWater) {
  VehicleForTests rov;
  auto vehicle = std::make_shared<twin::Vehicle>(*rov.agent.vehicle);
  vehicle->mounts = 2;
  rov.agent.vehicle = vehicle;
  twin::StepInput input;
  input.command.thruster = {0.5, -1};
  input.command.rudder_rad = 0.125;
  input.command.elevator_rad = 0.25;
  input.command.moving_mass_m = 0.375;
  input.command.volume_m3 = 0.5;
  input.around.water.velocity_m_s = {1, 2, 3};
  input.around.water.acceleration_m_s2 = {4, 5, 6};
  input.around.water.elevation_m = 0.75;
  input.around.wind_m_s = {7, 8, 0};
  twin::StepTime time{};
  time.step = 12;
  time.length_s = 0.25;
  const twin::HostedStep step{time, rov.agent, rov.state, input};
  HandReader read(physics_input(step, rov.name, rov.stamp));
  read.expect_header(rov.stamp, "rov/base_link");
  EXPECT_EQ(read.get<std::uint64_t>(), 12U);
  EXPECT_EQ(read.real(), 0.25);
  EXPECT_EQ(read.reals(3), (std::vector<double>{4, 3, -5}));
  (void)read.reals(4);
  EXPECT_EQ(read.reals(6), (std::vector<double>{1.5, -0.25, 0.5, 0.125, -0.5, 0.25}));
  EXPECT_EQ(read.reals(read.count()), (std::vector<double>{0.5, -1}));
  EXPECT_EQ(read.reals(4), (std::vector<double>{0.125, 0.25, 0.375, 0.5}));
  EXPECT_EQ(read.reals(3), (std::vector<double>{2, 1, -3}));  // ENU
  EXPECT_EQ(read.reals(3), (std::vector<double>{5, 4, -6}));
  EXPECT_EQ(read.reals(3), (std::vector<double>{8, 7, 0}));
  EXPECT_EQ(read.real(), 0.75);
  read.expect_end();
}

class AnswersOfTheHosted : public testing::TestWithParam<Order> {};

TEST_P(AnswersOfTheHosted, RequestForAPlace) {
  const HostAsked asked = read_host_request(
      HandWriter(GetParam()).put(std::uint64_t{7}).put(1U).put(std::uint8_t{2}).put(0.5).bytes());
  EXPECT_EQ(asked.token, 7U);
  EXPECT_EQ(asked.version, 1U);
  EXPECT_EQ(asked.role, 2);
  EXPECT_EQ(asked.timeout_s, 0.5);
}

TEST_P(AnswersOfTheHosted, CommandOfAnAgent) {
  HandWriter writer(GetParam());
  writer.put(std::uint64_t{9}).put(std::uint8_t{2}).doubles({1, 2, 3, 4, 5, 6});
  writer.put(2U).doubles({0.5, -1}).header(0, 0, "map").put(1U);
  writer.header(0, 0, "").doubles({1, 2, -3}).doubles({0, 0, 0, 1});
  const AgentAsked asked = read_agent_command(writer.bytes());
  EXPECT_EQ(asked.step, 9U);
  EXPECT_EQ(asked.kind, 2);
  EXPECT_EQ(asked.velocity.linear.y, -2);
  EXPECT_EQ(asked.velocity.angular.z, -6);
  EXPECT_EQ(asked.thrusters, (std::vector<double>{0.5, -1}));
  ASSERT_EQ(asked.places_m.size(), 1U);
  EXPECT_EQ(asked.places_m[0].x, 2);
  EXPECT_EQ(asked.places_m[0].z, 3);
}

TEST_P(AnswersOfTheHosted, WhatPhysicsMade) {
  HandWriter writer(GetParam());
  writer.put(std::uint64_t{9}).put(std::uint8_t{2}).doubles({1, 2, -3}).doubles({0, 0, 0, 1});
  writer.doubles({1, 2, 3, 4, 5, 6}).doubles({7, 8, 9, 10, 11, 12}).put(100.0);
  const PhysicsMade made = read_physics_output(writer.bytes());
  EXPECT_EQ(made.step, 9U);
  EXPECT_EQ(made.kind, 2);
  EXPECT_EQ(made.body.position_m.x, 2);
  EXPECT_EQ(made.body.position_m.z, 3);
  EXPECT_NEAR(twin::euler_angles(made.body.attitude).yaw_rad, std::acos(-1) / 2, 1e-15);  // east
  EXPECT_EQ(made.body.nu.linear.x, 1);
  EXPECT_EQ(made.body.nu.angular.z, -6);
  EXPECT_EQ(made.wrench.linear.z, -9);
  EXPECT_EQ(made.wrench.angular.x, 10);
  EXPECT_EQ(made.wrench.angular.y, -11);
  EXPECT_EQ(made.power_w, 100);
}

INSTANTIATE_TEST_SUITE_P(InBothOrders, AnswersOfTheHosted,
                         testing::Values(Order::little, Order::big), [](const auto& order) {
                           return order.param == Order::little ? "Little" : "Big";
                         });

}  // namespace
}  // namespace slackwater::dds::hosted_bytes_test
