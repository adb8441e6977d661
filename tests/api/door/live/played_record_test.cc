// What `slackwater live` recorded is played to it again, by the program.
#include <gtest/gtest.h>

#include "tests/api/door/live/live_records.h"
#include "tests/api/door/live/made_up_commands.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::played_record_test {
namespace {

/// An ROV that holds its place for a minute unless somebody drives it, as fast as it goes.
class PlayedRecord : public testing::Test {
 protected:
  PlayedRecord() {
    std::ofstream(scenario_)
        << "name: test\nseed: 7\nduration: 1min\nstep_s: 0.05\nlog_every_s: 0.5\n"
           "water: {made_up: {depth_m: 60}}\nvehicles:\n"
           "  - {name: rov 1, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: 10}, "
           "tasks: [{do: hold}]}\n";
  }
  ProgramResult live(const std::vector<std::string>& arguments) {
    std::vector<std::string> all{"live", scenario_.string(), "--real-time-factor", "0"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return run_program(all);
  }
  static std::vector<LiveMessage> on(const std::filesystem::path& record,
                                     const std::string& topic) {
    std::vector<LiveMessage> messages = messages_of(record);
    std::erase_if(messages, [&](const LiveMessage& message) { return message.topic != topic; });
    return messages;
  }

  TemporaryFolder folder_;
  std::filesystem::path scenario_ = folder_ / "scenario.yaml";
};

std::size_t times(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST_F(PlayedRecord, DrivesAgainAndPassesBy) {
  const auto drive = bag_of_commands(folder_ / "drive.mcap", "/rov_1/cmd_vel", twist(0.3, -0.1));
  for (const char* name : {"run.mcap", "run"}) {
    SCOPED_TRACE(name);
    const auto record = folder_ / name;
    const ProgramResult driven = live({"--play-commands", drive, "--record", record});
    ASSERT_EQ(driven.exit_code, 0) << driven.err;
    const auto commands = on(record, "/rov_1/cmd_vel");
    ASSERT_EQ(commands.size(), 21U);

    const auto again = folder_ / (std::string("again_") + name);
    const ProgramResult played = live({"--play-commands", record, "--record", again});
    ASSERT_EQ(played.exit_code, 0) << played.err;
    const auto handed_in = on(again, "/rov_1/cmd_vel");
    ASSERT_EQ(handed_in.size(), 21U);
    for (std::size_t i = 0; i < 21; ++i) {
      EXPECT_EQ(handed_in[i].payload, commands[i].payload) << i;
      // What is taken at the opening of a step is told at its end.
      EXPECT_NEAR(1e-9 * static_cast<double>(handed_in[i].log_time_ns - commands[i].log_time_ns),
                  0.05, 1e-6)
          << i;
    }

    const auto passed = folder_ / (std::string("passed_") + name);
    const ProgramResult traffic = live({"--play-traffic", record, "--record", passed});
    ASSERT_EQ(traffic.exit_code, 0) << traffic.err;
    const auto targets = on(passed, "/ais");
    EXPECT_EQ(targets.size(), 31U) << "each two seconds of a minute";
    for (const LiveMessage& target : targets) {
      const std::string text(target.payload.begin(), target.payload.end());
      EXPECT_NE(text.find("rov_1"), std::string::npos);
    }
  }
}

TEST_F(PlayedRecord, DamagedInItsMiddleIsToldOnceAndTheRunIsWhole) {
  const auto bag =
      bag_damaged_in_its_middle(folder_ / "half.mcap", "/rov_1/cmd_vel", twist(0.3, 0));
  const auto log = folder_ / "run.nc", record = folder_ / "run.mcap";
  const ProgramResult run = live({"--play-commands", bag, "--record", record, "--out", log});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(times(run.err, "half.mcap end here, the run goes on without them: "), 1U) << run.err;
  EXPECT_EQ(on(record, "/rov_1/cmd_vel").size(), 11U);
  EXPECT_EQ(expect_even_clock(messages_of(record)), 1201U);
  EXPECT_EQ(run_program({"replay", log}).exit_code, 0);
}

TEST_F(PlayedRecord, CutShortIsTold) {
  const auto record = folder_ / "run.mcap";
  ASSERT_EQ(live({"--play-commands",
                  bag_of_commands(folder_ / "drive.mcap", "/rov_1/cmd_vel", twist(0.3, 0)),
                  "--record", record})
                .exit_code,
            0);
  std::filesystem::resize_file(record, std::filesystem::file_size(record) * 3 / 4);
  for (const char* option : {"--play-commands", "--play-traffic"}) {
    const ProgramResult run = live({option, record});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_NE(run.err.find("run.mcap: cut short or damaged at byte"), std::string::npos)
        << option << "\n"
        << run.err;
  }
}

}  // namespace
}  // namespace slackwater::tests::played_record_test
