// A vehicle that joins a live run, in recordings and under the names of DDS.
#include <array>
#include <cstring>
#include <map>

#include "api/door/live/live_run.h"
#include "api/door/live/topics/recording_outlet.h"
#include "data/bag/bag.h"
#include "tests/support/temporary_folder.h"
#include "tests/twin/run/run_for_tests.h"

namespace slackwater::tests::newcomer_on_record_test {
namespace {

constexpr double step_s = 0.05;
constexpr std::uint64_t joins_before = 40, steps = 100;

const std::string scenario_text =
    calm_head(step_s) +
    "  - {name: rov 1, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: 10}, tasks: "
    "[{do: hold}]}\n"
    "log: {sensors: true}\n";

/// The place of a geometry_msgs/msg/PoseStamped in `map`: behind encapsulation, stamp and frame.
std::array<double, 3> place_of(const dds::Bytes& pose) {
  std::array<double, 3> place{};
  std::memcpy(place.data(), pose.data() + 4 + 8 + 8, sizeof place);
  return place;
}

struct Told {
  std::map<std::string, std::size_t> messages;  ///< by topic
  std::int64_t begin_ns = 0, first_pose_ns = 0;
  std::array<double, 3> first_place{};
};

Told told_in(const std::filesystem::path& path) {
  Told told;
  const auto bag = bag::open_bag(path);
  while (const auto message = bag->next()) {
    const std::string& topic = bag->channels()[message->channel].topic;
    if (told.messages.empty()) told.begin_ns = message->log_time_ns;
    if (++told.messages[topic] == 1 && topic == "/late/pose") {
      told.first_pose_ns = message->log_time_ns;
      told.first_place = place_of(dds::Bytes(message->payload.begin(), message->payload.end()));
    }
  }
  return told;
}

TEST(NewcomerOnRecord, HasItsChannelsInABagOfEitherKindFromItsFirstStepOn) {
  const TemporaryFolder folder;
  twin::Scenario scenario = twin::parse_scenario(scenario_text, "test.yaml");
  scenario.duration_s = steps * step_s;
  api::ScenarioWater water;
  water.surround = surround_of(scenario);
  const std::array files{folder / "run.mcap", folder / "run"};
  live::LiveSettings settings;
  std::vector<std::string> welcomed;
  settings.on_newcomer = [&](const twin::Agent& vehicle, const std::string& name) {
    welcomed.push_back(vehicle.name + " as " + name);
  };
  std::vector<std::shared_ptr<live::RecordingOutlet>> recordings;
  for (const auto& file : files) {
    recordings.push_back(std::make_shared<live::RecordingOutlet>(
        file, [](const std::string& text) { ADD_FAILURE() << text; }));
    settings.outlets.push_back(recordings.back());
  }
  std::unique_ptr<live::LiveRun> joined;
  api::RunChoice choice;
  choice.on_ready = [&](const api::RunInHand& hand) {
    joined = std::make_unique<live::LiveRun>(hand, settings);
    hand.run.at_opening([&, hand](const twin::StepTime& time) {
      if (time.step != joins_before) return;
      const twin::Newcomer late{"bluerov2_heavy", "late", {3, 7, 12}, 0};
      EXPECT_FALSE(hand.arbiter.spawn("somebody", late, hand.newcomer_yard, hand.arbiter.time_s()));
    });
    hand.run.at_barrier([&](const twin::StepTime& time) {
      EXPECT_EQ(joined->names().size(), time.step < joins_before ? 1U : 2U) << time.step;
    });
  };
  choice.on_over = [&] { joined.reset(); };
  (void)api::run_scenario(scenario, water, choice);
  EXPECT_EQ(welcomed, std::vector<std::string>{"late as late"});
  for (std::size_t i = 0; i < files.size(); ++i) {
    (void)recordings[i]->close();
    Told told = told_in(files[i]);
    // One before the first step, one after each; of the newcomer one after each of its own.
    EXPECT_EQ(told.messages["/rov_1/pose"], steps + 1);
    EXPECT_EQ(told.messages["/late/pose"], steps - joins_before);
    EXPECT_EQ(told.messages["/late/odometry"], steps - joins_before);
    for (const char* topic : {"/late/battery_state", "/late/mission_state", "/late/reserve",
                              "/late/active_waypoints", "/late/imu", "/late/fluid_pressure"})
      EXPECT_GT(told.messages[topic], 0U) << topic;
    EXPECT_NEAR(1e-9 * static_cast<double>(told.first_pose_ns - told.begin_ns),
                (joins_before + 1) * step_s, 1e-6);
    EXPECT_NEAR(told.first_place[0], 7, 0.05) << "east";
    EXPECT_NEAR(told.first_place[1], 3, 0.05) << "north";
    EXPECT_NEAR(told.first_place[2], -12, 0.05);
  }
}

}  // namespace
}  // namespace slackwater::tests::newcomer_on_record_test
