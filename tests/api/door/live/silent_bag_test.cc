// Bags whose commands might be passed over without a word: of another type, stamped by another
// clock, for others, too late. What is played is counted, the rest is said.
#include <nlohmann/json.hpp>
#include <variant>

#include "api/door/live/live_run.h"
#include "api/door/live/topics/recording_outlet.h"
#include "tests/api/door/live/live_records.h"
#include "tests/api/door/live/made_up_commands.h"
#include "tests/support/error_of.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"
#include "tests/twin/run/run_for_tests.h"

namespace slackwater::tests::silent_bag_test {
namespace {

constexpr double step_s = 0.05;
const char* const plain = "geometry_msgs/msg/Twist";
const char* const stamped = "geometry_msgs/msg/TwistStamped";

/// A header of stamp 0 and a frame, then the six numbers on a multiple of eight.
dds::Bytes stamped_twist(double surge_m_s, double yaw_rate_rad_s, const std::string& frame) {
  dds::Bytes bytes{0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  bytes.push_back(static_cast<std::uint8_t>(frame.size() + 1));
  bytes.resize(16);
  bytes.insert(bytes.end(), frame.begin(), frame.end());
  bytes.push_back(0);
  while ((bytes.size() - 4) % 8 != 0) bytes.push_back(0);
  const dds::Bytes numbers = twist(surge_m_s, yaw_rate_rad_s);
  bytes.insert(bytes.end(), numbers.begin() + 4, numbers.end());
  return bytes;
}

struct Message {
  std::string topic, type;
  double t_s = 0;
  dds::Bytes bytes;
};

/// Ten a second from `from_s` on.
std::vector<Message> drive(const std::string& topic, const char* type, double from_s, int count,
                           const dds::Bytes& bytes) {
  std::vector<Message> messages;
  for (int i = 0; i < count; ++i) messages.push_back({topic, type, from_s + 0.1 * i, bytes});
  return messages;
}

/// An ROV that holds its place for ten seconds unless it is driven.
class SilentBag : public testing::Test {
 protected:
  std::filesystem::path bag(const std::vector<Message>& messages, std::int64_t epoch_ns) {
    const auto path = folder_ / ("bag" + std::to_string(bags_++) + ".mcap");
    bag::Writer writer = bag::open_recording(path);
    for (const Message& message : messages)
      writer.write(writer.add_channel({message.topic, message.type, "", {}}),
                   epoch_ns + std::llround(1e9 * message.t_s), message.bytes);
    writer.close();
    return path;
  }
  api::ScenarioResult play(const std::filesystem::path& path) {
    const twin::Scenario scenario = ten_seconds();
    api::ScenarioWater water;
    water.surround = surround_of(scenario);
    live::LiveSettings settings;
    settings.played_commands = {path};
    settings.on_trouble = [this](const std::string& text) { troubles_.push_back(text); };
    if (!record_.empty())
      settings.outlets = {std::make_shared<live::RecordingOutlet>(
          record_, [](const std::string& text) { ADD_FAILURE() << text; })};
    std::unique_ptr<live::LiveRun> joined;
    api::RunChoice choice;
    choice.on_ready = [&](const api::RunInHand& hand) {
      joined = std::make_unique<live::LiveRun>(hand, settings);
    };
    choice.on_over = [&] {
      if (joined) played_ = joined->played().at(0);
      joined.reset();
    };
    return api::run_scenario(scenario, water, choice);
  }
  static twin::Scenario ten_seconds() {
    twin::Scenario scenario = twin::parse_scenario(
        calm_head(step_s) +
            "  - {name: rov, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: 10}, "
            "tasks: [{do: hold}]}\n",
        "test.yaml");
    scenario.duration_s = 10;
    return scenario;
  }
  [[nodiscard]] bool is_told(const std::string& words) const {
    return troubles_.size() == 1 && troubles_[0].find(words) != std::string::npos;
  }
  [[nodiscard]] std::string told() const {
    std::string all;
    for (const std::string& text : troubles_) all += text + "\n";
    return all;
  }

  static constexpr std::int64_t today_ns = 1'741'392'000'000'000'000;
  TemporaryFolder folder_;
  std::filesystem::path record_;
  std::vector<std::string> troubles_;
  live::PlayedBag played_;
  int bags_ = 0;
};

TEST_F(SilentBag, StampedVelocitiesDriveAsPlainOnesAndAreRecordedAsThose) {
  const auto plain_ones =
      play(bag(drive("/rov/cmd_vel", plain, 0, 21, twist(0.3, -0.1)), today_ns)).commands;
  for (const char* topic : {"/rov/cmd_vel", "/rov/cmd_vel_stamped"}) {
    record_ = folder_ / (std::string(topic + 5) + ".mcap");
    const auto stamped_ones =
        play(bag(drive(topic, stamped, 0, 21, stamped_twist(0.3, -0.1, "base_link")), today_ns))
            .commands;
    ASSERT_EQ(stamped_ones.size(), 21U) << topic << told();
    ASSERT_EQ(plain_ones.size(), 21U);
    for (std::size_t i = 0; i < 21; ++i) {
      EXPECT_EQ(stamped_ones[i].step, plain_ones[i].step);
      const auto v = std::get<twin::SetVelocity>(stamped_ones[i].what).velocity;
      EXPECT_EQ(v.surge_m_s, 0.3);
      EXPECT_EQ(v.yaw_rate_rad_s, 0.1);
    }
    std::size_t recorded = 0;
    for (const LiveMessage& message : messages_of(record_)) {
      if (message.topic != "/rov/cmd_vel") continue;
      EXPECT_EQ(message.payload, twist(0.3, -0.1));
      ++recorded;
    }
    EXPECT_EQ(recorded, 21U);
  }
  EXPECT_EQ(told(), "");
}

TEST_F(SilentBag, StampedInAFrameOfTheWorldIsRefusedAndCounted) {
  const auto result =
      play(bag(drive("/rov/cmd_vel", stamped, 0, 21, stamped_twist(0.3, 0, "map")), today_ns));
  EXPECT_TRUE(result.commands.empty());
  ASSERT_EQ(result.refusals.size(), 1U);
  EXPECT_EQ(result.refusals[0].count, 21U);
  EXPECT_EQ(result.refusals[0].reason, twin::RefusalReason::unreadable);
  EXPECT_NE(result.refusals[0].last_text.find("in the frame map"), std::string::npos);
  EXPECT_EQ(played_.handed_in, 21U);
  EXPECT_EQ(played_.taken, 0U);
}

TEST_F(SilentBag, AnotherTypeOnATopicOfOursIsNamedOnceWithBoth) {
  auto messages = drive("/rov/cmd_vel", "geometry_msgs/msg/Accel", 0, 21, twist(0.3, 0));
  const auto thrusters = drive("/rov/thrusters", "std_msgs/msg/Float64MultiArray", 0, 1,
                               {0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  messages.insert(messages.end(), thrusters.begin(), thrusters.end());
  (void)play(bag(messages, today_ns));
  EXPECT_TRUE(
      is_told("found /rov/cmd_vel as geometry_msgs/msg/Accel, expected "
              "geometry_msgs/msg/TwistStamped or geometry_msgs/msg/Twist; it is not played"))
      << told();
  EXPECT_EQ(played_.handed_in, 1U);
}

TEST_F(SilentBag, CommandsForOthersAreNamed) {
  auto messages = drive("/rov/cmd_vel", plain, 0, 21, twist(0.3, 0));
  messages.push_back({"/usv/cmd_vel", plain, 1, twist(0.3, 0)});
  EXPECT_EQ(play(bag(messages, today_ns)).commands.size(), 21U);
  EXPECT_TRUE(is_told("/usv/cmd_vel as geometry_msgs/msg/Twist, of no vehicle of this run (rov)"))
      << told();
}

TEST_F(SilentBag, AMessageStampedZeroBeforeTheClockDoesNotCount) {
  auto messages = drive("/rov/cmd_vel", plain, 2, 21, twist(0.3, 0));
  messages.insert(messages.begin(),
                  {"/clock", "rosgraph_msgs/msg/Clock", 0, {0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}});
  messages.insert(messages.begin(), {"/rosout",
                                     "std_msgs/msg/String",
                                     -1e-9 * static_cast<double>(today_ns),
                                     {0, 1, 0, 0, 1, 0, 0, 0, 0}});
  const auto commands = play(bag(messages, today_ns)).commands;
  ASSERT_EQ(commands.size(), 21U) << told();
  EXPECT_EQ(commands[0].step, 40U) << "two seconds behind the clock";
  EXPECT_TRUE(is_told("its first message (/rosout) lies 1741392000 s before the next")) << told();
}

TEST_F(SilentBag, OneALengthOfTheRunBeforeDoesNotCountAndOneWithinItDoes) {
  for (const double before_s : {10.0, 9.0}) {
    troubles_.clear();
    auto messages = drive("/rov/cmd_vel", plain, before_s, 21, twist(0.3, 0));
    messages.insert(messages.begin(),
                    {"/diag", "std_msgs/msg/String", 0, {0, 1, 0, 0, 1, 0, 0, 0, 0}});
    const auto commands = play(bag(messages, today_ns)).commands;
    if (before_s == 10) {
      ASSERT_EQ(commands.size(), 21U);
      EXPECT_EQ(commands[0].step, 0U);
      EXPECT_TRUE(is_told("its first message (/diag) lies 10 s before the next")) << told();
      EXPECT_FALSE(played_.left_from_s);
    } else {
      EXPECT_EQ(commands.size(), 10U) << "from 9.0 to 9.9 s";
      EXPECT_EQ(played_.handed_in, 10U);
      ASSERT_TRUE(played_.left_from_s);
      EXPECT_NEAR(*played_.left_from_s, 10, 1e-6);
      EXPECT_EQ(played_.text(),
                "bag1.mcap: 10 commands handed in, all taken; those from 10.00 s "
                "on lie behind the end of the run");
    }
  }
}

TEST_F(SilentBag, InTheTimeOfASimulationThatBeginsAtZeroIsPlayed) {
  const auto commands = play(bag(drive("/rov/cmd_vel", plain, 0, 21, twist(0.3, 0)), 0)).commands;
  ASSERT_EQ(commands.size(), 21U);
  EXPECT_EQ(commands[20].step, 40U);
  EXPECT_EQ(told(), "");
}

TEST_F(SilentBag, ThatWouldPlayNothingIsRefused) {
  std::vector<Message> messages;
  for (int i = 0; i < 15; ++i)
    messages.push_back({"/diag", "std_msgs/msg/String", 1.0 * i, {0, 1, 0, 0, 1, 0, 0, 0, 0}});
  messages.push_back({"/rov/cmd_vel", plain, 14.5, twist(0.3, 0)});
  EXPECT_NE(error_of([&] { return play(bag(messages, today_ns)); })
                .find("its first command comes 14.5 s after its first message, behind the end of "
                      "the run at 10 s"),
            std::string::npos);
  const std::string said = error_of([&] {
    return play(bag(drive("/rov/cmd_vel", "geometry_msgs/msg/Accel", 0, 3, twist(0, 0)), today_ns));
  });
  EXPECT_NE(said.find("found /rov/cmd_vel as geometry_msgs/msg/Accel"), std::string::npos) << said;
}

/// Bags as people have them, of 600 commands of a minute each.
TEST(SilentBags, OfStrangersArePlayedWholeOrSayWhy) {
  SLACKWATER_NEEDS_SHARED(shared);
  const auto cases = shared / "data/cases/silent_nothing";
  for (const char* name : {"zero_first", "early_minute", "stamped", "mixed"}) {
    SCOPED_TRACE(name);
    const ProgramResult run = run_program({"live", cases / "live_short.yaml", "--real-time-factor",
                                           "0", "--play-commands", cases / name, "--json"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const auto played = nlohmann::json::parse(run.out).at("played").at(0);
    EXPECT_EQ(played.at("handed_in"), 600) << run.err;
    EXPECT_EQ(played.at("taken"), 600) << run.err;
    EXPECT_TRUE(played.at("left_from_s").is_null());
    const bool is_odd = std::string(name) != "stamped";
    EXPECT_EQ(run.err.find("problem") != std::string::npos, is_odd) << run.err;
  }
}

}  // namespace
}  // namespace slackwater::tests::silent_bag_test
