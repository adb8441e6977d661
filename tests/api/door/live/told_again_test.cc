// The commands and refusals of a log, in the recording that a replay of it makes.
#include <map>
#include <nlohmann/json.hpp>

#include "api/door/dds/message/orders.h"
#include "api/door/live/live_run.h"
#include "api/door/live/topics/recording_outlet.h"
#include "tests/api/door/live/live_records.h"
#include "tests/api/door/live/made_up_commands.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"
#include "tests/twin/run/run_for_tests.h"

namespace slackwater::tests::told_again_test {
namespace {

using nlohmann::json;

using Topics = std::map<std::string, std::vector<LiveMessage>>;
Topics by_topic(const std::filesystem::path& record) {
  Topics topics;
  for (LiveMessage& message : messages_of(record)) topics[message.topic].push_back(message);
  return topics;
}

/// std_msgs/msg/String.
json json_in(const LiveMessage& message) {
  return json::parse(message.payload.begin() + 8, message.payload.end() - 1);
}

/// Velocities, some beyond the vehicle; thrusters, some of a wrong count; actuators, one of no name
/// of the vehicle; waypoints; and what is no message.
std::filesystem::path mixed_bag(const std::filesystem::path& path) {
  bag::Writer writer = bag::open_recording(path);
  const auto velocity = writer.add_channel({"/rov_1/cmd_vel", "geometry_msgs/msg/Twist", "", {}});
  const auto thrusters =
      writer.add_channel({"/rov_1/thrusters", "std_msgs/msg/Float64MultiArray", "", {}});
  const auto waypoints = writer.add_channel({"/rov_1/waypoints", "nav_msgs/msg/Path", "", {}});
  for (int i = 0; i < 40; ++i) writer.write(velocity, ns_of(0.1 * i), twist(0.3, 0.01 * i));
  for (int i = 0; i < 4; ++i) writer.write(velocity, ns_of(4 + 0.1 * i), twist(30, 0));
  for (int i = 0; i < 20; ++i)
    writer.write(thrusters, ns_of(5 + 0.1 * i), dds::thrusters_order(std::vector(8, 0.01 * i)));
  const auto actuators =
      writer.add_channel({"/rov_1/actuators", "slackwater_msgs/msg/Actuators", "", {}});
  for (int i = 0; i < 6; ++i)
    writer.write(actuators, ns_of(7 + 0.05 * i),
                 dds::actuators_order({{"thruster_2", "thruster_5"}, {0.1 * i, -0.1}, false}));
  writer.write(actuators, ns_of(7.4), dds::actuators_order({{"rudder"}, {0.1}, false}));
  for (int i = 0; i < 2; ++i)
    writer.write(thrusters, ns_of(7 + 0.1 * i), dds::thrusters_order({0.1, 0.1}));
  writer.write(velocity, ns_of(7.5), dds::Bytes{0, 1, 0, 0, 1, 2, 3, 4});
  twin::Waypoint there;
  there.position_m = {5, 5, 10};
  for (int i = 0; i < 10; ++i)
    writer.write(waypoints, ns_of(8 + 0.2 * i), dds::active_waypoints({there}, {}));
  writer.close();
  return path;
}

TEST(ToldAgain, ARecordingOfTheReplayHasWhatThatOfTheRunHas) {
  const TemporaryFolder folder;
  const auto scenario = folder / "scenario.yaml";
  std::ofstream(scenario)
      << "name: test\nseed: 7\nduration: 1min\nstep_s: 0.05\nlog_every_s: 0.5\n"
         "water: {made_up: {depth_m: 60}}\nvehicles:\n"
         "  - {name: rov 1, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: 10}, "
         "tasks: [{do: hold}]}\n";
  const auto log = folder / "run.nc", first = folder / "first.mcap", again = folder / "again.mcap";
  const ProgramResult run =
      run_program({"live", scenario, "--real-time-factor", "0", "--play-commands",
                   mixed_bag(folder / "drive.mcap"), "--record", first, "--out", log});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const ProgramResult replayed = run_program({"replay", log, "--record", again, "--json"});
  ASSERT_EQ(replayed.exit_code, 0) << replayed.err;

  Topics was = by_topic(first), is = by_topic(again);
  ASSERT_EQ(was["/rov_1/cmd_vel"].size(), 40U);
  ASSERT_EQ(was["/rov_1/thrusters"].size(), 20U);
  ASSERT_EQ(was["/rov_1/actuators"].size(), 6U);
  ASSERT_EQ(was["/rov_1/waypoints"].size(), 10U);
  ASSERT_EQ(was["/rov_1/refused"].size(), 8U);
  const auto refused_then = was["/rov_1/refused"], refused_now = is["/rov_1/refused"];
  // Whoever was at the helm then is not at it now.
  for (const char* apart : {"/rov_1/refused", "/rov_1/mission_state"}) {
    EXPECT_EQ(was.erase(apart), 1U);
    EXPECT_EQ(is.erase(apart), 1U);
  }
  for (const auto& [topic, messages] : was) EXPECT_EQ(is[topic], messages) << topic;
  EXPECT_EQ(is.size(), was.size());

  // By client and reason; in a log only the last of them has its words.
  std::map<std::string, json> last, told;
  std::map<std::string, std::uint64_t> count, counted;
  for (const LiveMessage& message : refused_then) {
    const json one = json_in(message);
    last[one.at("reason")] = one;
    ++count[one.at("reason")];
  }
  for (const LiveMessage& message : refused_now) {
    const json one = json_in(message);
    told[one.at("reason")] = one;
    counted[one.at("reason")] += one.value("count", std::uint64_t{1});
    told[one.at("reason")].erase("count");
  }
  EXPECT_EQ(counted, count);
  EXPECT_EQ(told, last);
  EXPECT_EQ(count.size(), 3U) << "out_of_range, wrong_count, unreadable";
  const json commands = json::parse(replayed.out).at("commands");
  EXPECT_EQ(commands.at("refused"), json({{"in_log", 8}, {"recorded", 8}, {"messages", 3}}));
  EXPECT_EQ(commands.at("taken"), json::parse(R"([{"kind": "actuators", "in_log": 6, "recorded": 6},
                            {"kind": "thrusters", "in_log": 20, "recorded": 20},
                            {"kind": "velocity", "in_log": 40, "recorded": 40},
                            {"kind": "waypoints", "in_log": 10, "recorded": 10}])"));
  std::filesystem::remove(again);
  const ProgramResult words = run_program({"replay", log, "--record", again});
  EXPECT_NE(words.out.find("recorded: 76 of 76 commands, 8 of 8 refusals in 3 messages\n"),
            std::string::npos)
      << words.out;
}

TEST(ToldAgain, WhatHasNoTopicIsSaidByKind) {
  twin::Scenario scenario = twin::parse_scenario(
      calm_head(0.05) +
          "  - {name: rov 1, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: 10}, "
          "tasks: [{do: hold}]}\n",
      "test.yaml");
  scenario.duration_s = 5;
  api::ScenarioWater water;
  water.surround = surround_of(scenario);
  api::RunChoice choice;
  const auto add = [&](std::uint64_t step, const twin::CommandWhat& what) {
    twin::Command command;
    command.step = step;
    command.what = what;
    command.received_s = 0.05 * static_cast<double>(step);
    choice.record.commands.push_back(command);
  };
  add(10, twin::SetVelocity{{0.1, 0, 0, 0}});
  add(20, twin::HoldHere{});
  add(30, twin::GoHome{});
  add(40, twin::HoldHere{});
  choice.record.refusals = {
      {"a", "rov 1", twin::RefusalReason::stale, 2, 1, "late"},
      {"a", "rov_1", twin::RefusalReason::unreadable, 1, 2, "no message"},
      {"a", "nobody", twin::RefusalReason::unknown_vehicle, 4, 3, "there is none"}};
  std::unique_ptr<live::LiveRun> joined;
  live::RecordTold told;
  choice.on_ready = [&](const api::RunInHand& hand) {
    joined = std::make_unique<live::LiveRun>(hand, live::LiveSettings{});
  };
  choice.on_over = [&] {
    told = joined->record_told();
    joined.reset();
  };
  (void)api::run_scenario(scenario, water, choice);
  EXPECT_EQ(told.text(),
            "1 of 4 commands (no topic: 2 hold, 1 home), 3 of 7 refusals in 2 messages (the others "
            "are of no vehicle of the run)");
  EXPECT_EQ(told.commands.at("hold"), (live::RecordTold::Share{2, 0}));
  EXPECT_EQ(live::RecordTold().text(), "");
}

}  // namespace
}  // namespace slackwater::tests::told_again_test
