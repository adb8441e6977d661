// Bags played back: as commands of a client, as vessels that pass by.
#include <cstring>

#include "api/live/bag_traffic.h"
#include "api/live/live_run.h"
#include "data/bag/recording.h"
#include "fields/base/error.h"
#include "tests/support/temporary_folder.h"
#include "tests/twin/simulate/run_for_tests.h"

namespace slackwater::tests {
namespace {

constexpr double step_s = 0.05;

/// geometry_msgs/msg/Twist: six numbers behind the encapsulation header.
dds::Bytes twist(double surge_m_s, double yaw_rate_rad_s) {
  dds::Bytes bytes(52);
  bytes[1] = 1;
  std::memcpy(bytes.data() + 4, &surge_m_s, 8);
  std::memcpy(bytes.data() + 44, &yaw_rate_rad_s, 8);
  return bytes;
}

std::int64_t ns_of(double t_s) { return 1'700'000'000'000'000'000 + std::llround(1e9 * t_s); }

/// A bag that begins with a clock, and has `topic` from 2 to 4 s, ten times a second.
std::filesystem::path bag_of_commands(const std::filesystem::path& path, const std::string& topic,
                                      const dds::Bytes& message) {
  bag::Writer writer = bag::open_recording(path);
  const auto clock = writer.add_channel({"/clock", "rosgraph_msgs/msg/Clock", "", {}});
  const auto commands = writer.add_channel({topic, "geometry_msgs/msg/Twist", "", {}});
  writer.write(clock, ns_of(0), dds::Bytes{0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  for (int i = 0; i <= 20; ++i) writer.write(commands, ns_of(2 + 0.1 * i), message);
  writer.close();
  return path;
}

const std::string scenario_text =
    calm_head(step_s) +
    "  - {name: rov 1, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: 10}, tasks: "
    "[{do: hold}]}\n";

api::ScenarioResult played(const std::filesystem::path& bag, api::ScenarioWater water,
                           const twin::Scenario& scenario) {
  std::unique_ptr<live::LiveRun> joined;
  live::LiveSettings settings;
  settings.played_commands = {bag};
  api::RunChoice choice;
  choice.on_ready = [&](const api::RunInHand& hand) {
    joined = std::make_unique<live::LiveRun>(hand, settings);
  };
  choice.on_over = [&] { joined.reset(); };
  return api::run_scenario(scenario, water, choice);
}

twin::Scenario ten_seconds() {
  twin::Scenario scenario = twin::parse_scenario(scenario_text, "test.yaml");
  scenario.duration_s = 10;
  return scenario;
}

api::ScenarioWater water_of(const twin::Scenario& scenario) {
  api::ScenarioWater water;
  water.surround = surround_of(scenario);
  return water;
}

TEST(PlayedBag, CommandsTakeEffectAtTheStepAtWhichTheyCame) {
  const TemporaryFolder folder;
  const twin::Scenario scenario = ten_seconds();
  const auto bag = bag_of_commands(folder / "drive.mcap", "/rov_1/cmd_vel", twist(0.3, -0.1));
  const api::ScenarioResult result = played(bag, water_of(scenario), scenario);
  ASSERT_EQ(result.commands.size(), 21U);
  for (std::size_t i = 0; i < 21; ++i) {
    EXPECT_EQ(result.commands[i].step, 40 + 2 * i) << "2 s and a tenth more each";
    EXPECT_EQ(result.commands[i].source, "bag drive.mcap");
    const auto velocity = std::get<twin::SetVelocity>(result.commands[i].what).velocity;
    EXPECT_EQ(velocity.surge_m_s, 0.3);
    EXPECT_EQ(velocity.yaw_rate_rad_s, 0.1) << "to starboard, where ROS counts to port";
  }
  EXPECT_TRUE(result.refusals.empty());
  EXPECT_GT(result.vehicles[0].sailed_m, 0.3);
}

TEST(PlayedBag, WhatTheVehicleCannotDoIsRefusedAsOfAnyClient) {
  const TemporaryFolder folder;
  const twin::Scenario scenario = ten_seconds();
  const auto bag = bag_of_commands(folder / "wild", "/rov_1/cmd_vel", twist(30, 0));
  const api::ScenarioResult result = played(bag, water_of(scenario), scenario);
  EXPECT_TRUE(result.commands.empty());
  ASSERT_EQ(result.refusals.size(), 1U);
  EXPECT_EQ(result.refusals[0].count, 21U);
  EXPECT_EQ(result.refusals[0].source, "bag wild");
}

TEST(PlayedBag, OfOtherVehiclesIsRefused) {
  const TemporaryFolder folder;
  const twin::Scenario scenario = ten_seconds();
  const auto bag = bag_of_commands(folder / "other.mcap", "/usv/cmd_vel", twist(0.3, 0));
  try {
    (void)played(bag, water_of(scenario), scenario);
    FAIL() << "it was taken";
  } catch (const Error& e) {
    EXPECT_NE(e.message().find("expected topics like /rov_1/cmd_vel"), std::string::npos)
        << e.message();
  }
}

/// A vessel that went north at 2 m/s, told ten times a second, passes by at 2 m/s.
TEST(PlayedBag, ItsVehiclesPassByWhereTheyWereThen) {
  const TemporaryFolder folder;
  const twin::Scenario scenario = ten_seconds();
  api::ScenarioWater water = water_of(scenario);
  const twin::ReadyRun ready = twin::set_up(scenario, water.surround);
  {
    bag::Writer writer = bag::open_recording(folder / "tug.mcap");
    const auto pose = writer.add_channel({"/tug/pose", "geometry_msgs/msg/PoseStamped", "", {}});
    twin::AgentState state = ready.states[0];
    for (int i = 0; i <= 100; ++i) {
      state.vehicle.body.position_m = {0.2 * i, 50, 0};
      writer.write(pose, ns_of(0.1 * i), dds::pose(state, dds::stamp_of(ready.start, 0.1 * i)));
    }
    writer.close();
  }
  live::add_bag_traffic(folder / "tug.mcap", scenario, water);
  ASSERT_EQ(water.surround.vessels.size(), 1U);
  const twin::TrafficVessel& tug = water.surround.vessels[0];
  EXPECT_EQ(tug.name, "tug");
  EXPECT_EQ(tug.id, 980'000'001U);
  const twin::TrackState at = tug.track.at(4.5);
  ASSERT_TRUE(at.is_known());
  EXPECT_NEAR(at.position_m.x, 9, 1e-9);
  EXPECT_NEAR(at.position_m.y, 50, 1e-9);
  EXPECT_NEAR(at.velocity_m_s.x, 2, 1e-9);
  EXPECT_NE(water.traffic_files.find("tug.mcap "), std::string::npos) << "said in the log";
  EXPECT_THROW(live::add_bag_traffic(bag_of_commands(folder / "no.mcap", "/a/cmd_vel", twist(0, 0)),
                                     scenario, water),
               Error)
      << "nobody tells where he is";
}

}  // namespace
}  // namespace slackwater::tests
