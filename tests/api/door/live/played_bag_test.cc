// Bags played back: as commands of a client, as vessels that pass by.
#include "api/door/live/bag_traffic.h"
#include "api/door/live/live_run.h"
#include "api/door/live/topics/recording_outlet.h"
#include "fields/base/error.h"
#include "tests/api/door/live/live_records.h"
#include "tests/api/door/live/made_up_commands.h"
#include "tests/support/error_of.h"
#include "tests/support/temporary_folder.h"
#include "tests/twin/run/run_for_tests.h"

namespace slackwater::tests::played_bag_test {
namespace {

constexpr double step_s = 0.05;

const std::string scenario_text =
    calm_head(step_s) +
    "  - {name: rov 1, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: 10}, tasks: "
    "[{do: hold}]}\n";

api::ScenarioResult played(const std::filesystem::path& bag, const api::ScenarioWater& water,
                           const twin::Scenario& scenario,
                           std::vector<std::string>* troubles = nullptr) {
  std::unique_ptr<live::LiveRun> joined;
  live::LiveSettings settings;
  settings.played_commands = {bag};
  if (troubles != nullptr)
    settings.on_trouble = [troubles](const std::string& text) { troubles->push_back(text); };
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
  EXPECT_GT(result.account.vehicles[0].track.sailed_m, 0.3);
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

/// Half of its messages can be read; then its bytes are not those that were written.
TEST(PlayedBag, DamagedInItsMiddleEndsAndTheRunGoesOn) {
  const TemporaryFolder folder;
  const twin::Scenario scenario = ten_seconds();
  const auto bag = bag_damaged_in_its_middle(folder / "half.mcap", "/rov_1/cmd_vel", twist(0.3, 0));
  std::vector<std::string> troubles;
  const api::ScenarioResult result = played(bag, water_of(scenario), scenario, &troubles);
  EXPECT_EQ(result.commands.size(), 11U);
  EXPECT_FALSE(result.stopped_at_step.has_value());
  ASSERT_EQ(troubles.size(), 1U);
  EXPECT_NE(troubles[0].find("half.mcap end here, the run goes on without them: "),
            std::string::npos)
      << troubles[0];
}

TEST(PlayedBag, CutShortIsToldBeforeTheRun) {
  const TemporaryFolder folder;
  const twin::Scenario scenario = ten_seconds();
  const auto bag = folder / "cut.mcap";
  const std::uintmax_t half = write_commands(bag, "/rov_1/cmd_vel", twist(0.3, 0));
  std::filesystem::resize_file(bag, half + 30);
  std::vector<std::string> troubles;
  const api::ScenarioResult result = played(bag, water_of(scenario), scenario, &troubles);
  EXPECT_EQ(result.commands.size(), 11U);
  ASSERT_EQ(troubles.size(), 1U);
  EXPECT_NE(troubles[0].find("cut.mcap: cut short or damaged at byte"), std::string::npos)
      << troubles[0];
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

/// A bag with a vessel of which one message is not as it should be.
class DamagedTraffic {
 public:
  std::string refusal(const twin::Triple<double>& position_m, std::size_t bytes_cut = 0) {
    const auto path = folder_ / ("tug" + std::to_string(bags_++) + ".mcap");
    {
      bag::Writer writer = bag::open_recording(path);
      const auto pose = writer.add_channel({"/tug/pose", "geometry_msgs/msg/PoseStamped", "", {}});
      twin::AgentState state = twin::set_up(scenario_, water_.surround).states[0];
      for (const double t_s : {0.0, 2.0, 4.0}) {
        state.vehicle.body.position_m = {0, 50, 0};
        if (t_s == 2) state.vehicle.body.position_m = position_m;
        dds::Bytes message = dds::pose(state, {});
        if (t_s == 2) message.resize(message.size() - bytes_cut);
        writer.write(pose, ns_of(t_s), message);
      }
      writer.close();
    }
    return error_of([&] {
      live::add_bag_traffic(path, scenario_, water_);
      return 0;
    });
  }
  [[nodiscard]] const api::ScenarioWater& water() const { return water_; }

 private:
  TemporaryFolder folder_;
  twin::Scenario scenario_ = ten_seconds();
  api::ScenarioWater water_ = water_of(scenario_);
  int bags_ = 0;
};

TEST(PlayedBag, AVesselWhereNoneCanBeIsRefusedByFileTopicAndMessage) {
  DamagedTraffic bags;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  constexpr double endless = std::numeric_limits<double>::infinity();
  const std::string named =
      ".mcap, topic /tug/pose, the message of 1700000002000000000 ns (2 s from its first): ";
  for (const twin::Triple<double>& place_m :
       {twin::Triple<double>{none, 0, 0}, {0, endless, 0}, {2e7, 0, 0}, {0, -1.1e6, 0}}) {
    const std::string said = bags.refusal(place_m);
    EXPECT_NE(said.find(named + "found a place of north "), std::string::npos) << said;
    EXPECT_NE(said.find("at most 1e+06 m from the origin"), std::string::npos) << said;
  }
  EXPECT_TRUE(bags.water().surround.vessels.empty());
  const std::string said = bags.refusal({0, 50, 0}, 30);
  EXPECT_NE(said.find(named + "the message is cut short"), std::string::npos) << said;
  EXPECT_EQ(bags.refusal({9e5, -9e5, 0}), "no error");
}

/// At 85 degrees north, 900 km to the north are beyond the pole: it is not told of, nothing more.
TEST(PlayedBag, AVesselBeyondThePoleEndsNoRun) {
  const TemporaryFolder folder;
  twin::Scenario scenario = ten_seconds();
  scenario.origin = GeoPoint::from_degrees(85, 5);
  scenario.has_origin = true;
  api::ScenarioWater water = water_of(scenario);
  std::vector<twin::TrackPoint> far, near;
  for (const double t_s : {0.0, 20.0}) {
    far.push_back({t_s, {9e5, 0, 0}, std::nullopt, std::nullopt});
    near.push_back({t_s, {100, 0, 0}, std::nullopt, std::nullopt});
  }
  water.surround.vessels = {{1, "far", {}, {}, twin::Track(far)},
                            {2, "near", {}, {}, twin::Track(near)}};
  live::LiveSettings settings;
  settings.outlets = {std::make_shared<live::RecordingOutlet>(
      folder / "run.mcap", [](const std::string& text) { ADD_FAILURE() << text; })};
  std::unique_ptr<live::LiveRun> joined;
  api::RunChoice choice;
  choice.on_ready = [&](const api::RunInHand& hand) {
    ASSERT_NEAR(hand.origin.latitude_deg(), 85, 1e-9);
    joined = std::make_unique<live::LiveRun>(hand, settings);
  };
  choice.on_over = [&] { joined.reset(); };
  (void)api::run_scenario(scenario, water, choice);
  settings.outlets.clear();
  std::size_t told = 0;
  for (const LiveMessage& message : messages_of(folder / "run.mcap"))
    told += message.topic == "/ais" ? 1 : 0;
  EXPECT_EQ(told, 6U) << "the near one alone, each two seconds";
}

}  // namespace
}  // namespace slackwater::tests::played_bag_test
