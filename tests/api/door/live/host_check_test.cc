// What physics from outside may answer, and what becomes of it.
#include "api/door/live/host_check.h"

#include <array>
#include <cmath>
#include <limits>

#include "api/door/live/command_topics.h"
#include "api/door/live/host_link.h"
#include "fields/base/error.h"
#include "tests/support/contains.h"
#include "tests/support/error_of.h"
#include "tests/support/vehicle_for_tests.h"
#include "tests/twin/run/run_for_tests.h"
#include "twin/vehicle/actuator_channels.h"

namespace slackwater::tests::host_check_test {
namespace {

/// An ROV at rest in still water, and a step of it.
struct Standing {
  twin::ReadyRun ready = ready_of(
      calm_head(0.05) +
      "  - {name: rov, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: 10}}\n");
  twin::StepInput input{};
  twin::StepTime time{7, 0.35, 0.05};
  [[nodiscard]] twin::HostedStep step() const {
    return {time, ready.agents[0], ready.states[0], input};
  }
  [[nodiscard]] dds::PhysicsMade still() const {
    dds::PhysicsMade made;
    made.step = 7;
    made.kind = 1;
    made.body = ready.states[0].vehicle.body;
    made.power_w = 20;
    return made;
  }
};

TEST(HostCheck, WhatMovesAsBodiesDoIsTaken) {
  const Standing standing;
  EXPECT_EQ(live::unphysical(standing.still(), standing.step()), std::nullopt);
  dds::PhysicsMade fast = standing.still();
  fast.body.nu.linear.x = 9;  // 180 m/s2 over a twentieth of a second
  fast.body.position_m.x += 0.5 * 9 * 0.05;
  EXPECT_EQ(live::unphysical(fast, standing.step()), std::nullopt);
}

TEST(HostCheck, EachLieIsNamed) {
  constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
  constexpr double endless = std::numeric_limits<double>::infinity();
  const Standing standing;
  const auto said = [&](const auto& lie) {
    dds::PhysicsMade made = standing.still();
    lie(made);
    return live::unphysical(made, standing.step()).value_or("nothing");
  };
  const auto has = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos ? testing::AssertionSuccess()
                                                : testing::AssertionFailure() << text;
  };
  EXPECT_TRUE(has(said([&](auto& m) { m.body.position_m.x = no_number; }), "not a number"));
  EXPECT_TRUE(has(said([&](auto& m) { m.body.nu.angular.z = endless; }), "not a number"));
  EXPECT_TRUE(has(said([&](auto& m) { m.body.attitude.w = 2; }), "of length 2"));
  EXPECT_TRUE(has(said([&](auto& m) { m.body.nu.linear.y = 101; }), "101 m/s"));
  EXPECT_TRUE(has(said([&](auto& m) { m.body.nu.linear.x = 11; }), "a change of speed of"));
  EXPECT_TRUE(has(said([&](auto& m) { m.body.position_m.z += 0.2; }), "a jump of 0.2 m"));
  EXPECT_TRUE(has(said([&](auto& m) { m.power_w = -1; }), "a power of -1 W"));
  EXPECT_TRUE(has(said([&](auto& m) { m.power_w = no_number; }), "a power of"));
  EXPECT_TRUE(has(said([&](auto& m) { m.kind = 3; }), "of kind 3"));
  EXPECT_TRUE(has(said([&](auto& m) {
                    m.kind = 2;
                    m.wrench.linear.x = 1e6;
                  }),
                  "a wrench of"));
}

/// From rest, before drag has a say: the change of velocity is the push over the mass that it
/// moves, that of the water along with it included.
TEST(HostCheck, AWrenchMovesTheVehicleByItsMassAndTheWatersAlongWithIt) {
  const Standing standing;
  const twin::Body& body = standing.ready.agents[0].vehicle->body;
  dds::PhysicsMade made = standing.still();
  made.kind = 2;
  const twin::VehicleState<double> drifting = live::state_after(made, standing.step());
  constexpr double push_n = 1;
  made.wrench.linear.x = push_n;
  const twin::VehicleState<double> pushed = live::state_after(made, standing.step());
  twin::Spatial<double> force;
  force.linear.x = push_n;
  const double expected_m_s = 0.05 * (body.inverse_mass * force).linear.x;
  // Drag takes of the first millimetres per second less than a hundredth.
  EXPECT_NEAR(pushed.body.nu.linear.x - drifting.body.nu.linear.x, expected_m_s,
              0.03 * expected_m_s);
  EXPECT_GT(expected_m_s, 1e-3);
}

TEST(HostCheck, WhatItDrawsComesOutOfTheBattery) {
  const Standing standing;
  dds::PhysicsMade made = standing.still();
  made.power_w = 200;
  const twin::VehicleState<double> after = live::state_after(made, standing.step());
  const twin::VehicleState<double>& before = standing.ready.states[0].vehicle;
  EXPECT_DOUBLE_EQ(after.drawn_j - before.drawn_j, 200 * 0.05);
  EXPECT_LT(after.battery.charge, before.battery.charge);
  EXPECT_NEAR(after.current_a * after.bus_voltage_v, 200, 0.01);
}

const twin::Vehicle& rov() {
  static const twin::Vehicle vehicle = bundled_vehicle("bluerov2_heavy");
  return vehicle;
}
std::optional<twin::CommandWhat> command_of(const dds::AgentAsked& asked) {
  return live::command_of(asked, rov());
}

TEST(HostCheck, AgentsAskForWhatThereIs) {
  dds::AgentAsked asked;
  EXPECT_FALSE(command_of(asked)) << "nothing";
  asked.kind = 1;
  asked.velocity.linear = {0.5, 0.1, -0.2};
  asked.velocity.angular.z = 0.3;
  const auto velocity = std::get<twin::SetVelocity>(command_of(asked).value()).velocity;
  EXPECT_EQ(velocity.surge_m_s, 0.5);
  EXPECT_EQ(velocity.heave_m_s, -0.2);
  EXPECT_EQ(velocity.yaw_rate_rad_s, 0.3);
  asked.kind = 3;
  asked.places_m = {{1, 2, 3}, {4, 5, 6}};
  const auto reroute = std::get<twin::Reroute>(command_of(asked).value());
  ASSERT_EQ(reroute.waypoints.size(), 2U);
  EXPECT_EQ(reroute.waypoints[1].position_m.z, 6);
  EXPECT_FALSE(reroute.loop);
  asked.kind = 9;
  EXPECT_THROW((void)command_of(asked), Error);
}

// A number for each actuator, in the order that it was told; none where it is no number.
TEST(HostCheck, AgentsAskForActuatorsInTheirOrder) {
  const twin::Vehicle auv = bundled_vehicle("lrauv_tethys");
  EXPECT_EQ(twin::channel_names(auv), "thruster_1, rudder, elevator, moving_mass, volume");
  dds::AgentAsked asked;
  asked.thrusters = {0.5, -1, std::nan(""), std::nan(""), 0.25};
  for (const std::uint8_t kind : std::array<std::uint8_t, 2>{7, 8}) {
    asked.kind = kind;
    const auto set = std::get<twin::SetActuators>(live::command_of(asked, auv).value());
    EXPECT_EQ(set.is_physical, kind == 8);
    twin::ActuatorValues wanted;
    wanted.give(0, 0.5);
    wanted.give(twin::rudder_channel, -1);
    wanted.give(twin::volume_channel, 0.25);
    EXPECT_EQ(set.given, wanted);
  }
  asked.thrusters.pop_back();
  EXPECT_TRUE(contains(error_of([&] { return live::command_of(asked, auv); }),
                       "a command of 4 actuators; expected one number for each of thruster_1, "
                       "rudder"));
}

/// So that a bag of it, played, drives as the agent did.
TEST(HostCheck, WhatAgentsAskForIsHeardAsOnTheTopicThatHasIt) {
  const auto heard_on = [](const char* topic, const char* type, const dds::AgentAsked& asked) {
    const dds::Bytes heard = live::order_of(*command_of(asked), rov());
    return live::command_topic_of(topic, type)->read(heard, rov());
  };
  dds::AgentAsked asked;
  EXPECT_FALSE(command_of(asked)) << "nothing";
  asked.kind = 1;
  asked.velocity.linear = {0.5, 0.1, -0.2};
  asked.velocity.angular.z = 0.3;
  const auto velocity =
      std::get<twin::SetVelocity>(heard_on("cmd_vel", "geometry_msgs/msg/Twist", asked)).velocity;
  EXPECT_EQ(velocity.surge_m_s, 0.5);
  EXPECT_EQ(velocity.sway_m_s, 0.1);
  EXPECT_EQ(velocity.heave_m_s, -0.2);
  EXPECT_EQ(velocity.yaw_rate_rad_s, 0.3);
  asked.kind = 2;
  asked.thrusters = {0.25, -1};
  EXPECT_EQ(
      std::get<twin::SetThrusters>(heard_on("thrusters", "std_msgs/msg/Float64MultiArray", asked))
          .share,
      asked.thrusters);
  for (const std::uint8_t kind : std::array<std::uint8_t, 2>{7, 8}) {
    asked.kind = kind;
    asked.thrusters = {0.25, -1, std::nan(""), 0, 0, 0, 0, 0.5};
    const auto set =
        std::get<twin::SetActuators>(heard_on("actuators", "slackwater_msgs/msg/Actuators", asked));
    EXPECT_EQ(set.given, std::get<twin::SetActuators>(*command_of(asked)).given);
    EXPECT_FALSE(set.given.has(2));
    EXPECT_EQ(set.is_physical, kind == 8);
  }
  asked.kind = 3;
  asked.places_m = {{1, 2, 3}, {4, 5, 6}};
  const auto reroute = std::get<twin::Reroute>(heard_on("waypoints", "nav_msgs/msg/Path", asked));
  ASSERT_EQ(reroute.waypoints.size(), 2U);
  EXPECT_EQ(reroute.waypoints[1].position_m.x, 4);
  EXPECT_EQ(reroute.waypoints[1].position_m.z, 6);
  for (const std::uint8_t kind : std::array<std::uint8_t, 3>{4, 5, 6}) {
    asked.kind = kind;
    EXPECT_TRUE(live::order_of(*command_of(asked), rov()).empty()) << "no topic has it";
  }
}

}  // namespace
}  // namespace slackwater::tests::host_check_test
