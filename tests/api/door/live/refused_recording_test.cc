// What `--record` leaves behind of runs that never began, and what is said of those that did.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "tests/api/door/live/live_records.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::refused_recording_test {
namespace {

class RefusedRecording : public ::testing::Test {
 protected:
  /// The program with both kinds of recording.
  ProgramResult recorded(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--record", mcap_, "--record", rosbag_, "--json"});
    return run_program(arguments);
  }
  void expect_nothing_is_left() {
    EXPECT_FALSE(std::filesystem::exists(mcap_));
    EXPECT_FALSE(std::filesystem::exists(rosbag_));
  }
  std::filesystem::path log_of_a_run() {
    std::filesystem::path log = folder_ / "run.nc";
    const ProgramResult run = run_program(
        {"live", scenario(), "--real-time-factor", "0", "--out", log.string(), "--json"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(nlohmann::json::parse(run.out).at("recordings"), nlohmann::json::array());
    return log;
  }
  /// A minute of what takes twenty.
  std::string scenario() {
    std::ifstream in(live_scenario());
    std::ofstream out(folder_ / "short.yaml");
    for (std::string line; std::getline(in, line);)
      out << (line.starts_with("duration:") ? "duration: 1min" : line) << '\n';
    return (folder_ / "short.yaml").string();
  }

  TemporaryFolder folder_;
  const std::string mcap_ = (folder_ / "r.mcap").string(), rosbag_ = (folder_ / "r").string();
};

TEST_F(RefusedRecording, OfALogThatIsNoneLeavesThePlaceFreeForTheNextTry) {
  const std::filesystem::path log = log_of_a_run(), half = folder_ / "half.nc";
  std::filesystem::copy(log, half);
  std::filesystem::resize_file(half, std::filesystem::file_size(log) / 2);
  EXPECT_EQ(recorded({"replay", half.string()}).exit_code, 3);
  expect_nothing_is_left();
  const ProgramResult again = recorded({"replay", log.string()});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  const auto told = nlohmann::json::parse(again.out).at("recordings");
  ASSERT_EQ(told.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string& path = i == 0 ? mcap_ : rosbag_;
    EXPECT_EQ(told[i].at("path"), path);
    EXPECT_EQ(told[i].at("messages"), messages_of(path).size());
    EXPECT_EQ(told[i].at("complete"), true);
  }
}

TEST_F(RefusedRecording, OfABagThatCannotBePlayedLeavesNothing) {
  std::ofstream(folder_ / "bad.mcap") << "no bag at all";
  for (const char* play : {"--play-commands", "--play-traffic"}) {
    const ProgramResult run = recorded(
        {"live", scenario(), "--real-time-factor", "0", play, (folder_ / "bad.mcap").string()});
    EXPECT_EQ(run.exit_code, 3);
    EXPECT_NE(run.err.find("bad.mcap"), std::string::npos) << run.err;
    expect_nothing_is_left();
  }
}

TEST_F(RefusedRecording, WhatLiesThereAlreadyIsNotTouched) {
  std::ofstream(folder_ / "r.mcap") << "precious";
  const ProgramResult run = recorded({"live", scenario(), "--real-time-factor", "0"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NE(run.err.find("found something at " + mcap_ + " already"), std::string::npos) << run.err;
  EXPECT_EQ(std::filesystem::file_size(mcap_), 8U);
  EXPECT_FALSE(std::filesystem::exists(rosbag_));
}

TEST_F(RefusedRecording, TheSamePlaceTwiceLeavesNothing) {
  const ProgramResult run = run_program(
      {"live", scenario(), "--real-time-factor", "0", "--record", mcap_, "--record", mcap_});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NE(run.err.find("found something at " + mcap_ + " already"), std::string::npos) << run.err;
  expect_nothing_is_left();
}

/// The log fits the disk, its recording does not.
TEST_F(RefusedRecording, OneThatTheDiskEndsIsAnErrorOfAReplayThatIsTheSame) {
  const std::filesystem::path log = log_of_a_run();
  const auto before = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit most{std::filesystem::file_size(log) + 4096, RLIM_INFINITY};
  const rlimit any{RLIM_INFINITY, RLIM_INFINITY};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &most), 0);
  const pid_t program = start_program({"replay", log.string(), "--record", mcap_, "--json"}, {},
                                      folder_ / "out", folder_ / "err");
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &any), 0);
  std::signal(SIGXFSZ, before);
  EXPECT_EQ(wait_for_program(program), 5);
  std::ifstream out(folder_ / "out");
  const auto told = nlohmann::json::parse(out);
  EXPECT_EQ(told.at("identical"), true);
  const auto& recording = told.at("recordings").at(0);
  EXPECT_EQ(recording.at("complete"), false);
  EXPECT_EQ(recording.at("messages"), messages_of(mcap_).size());
}

}  // namespace
}  // namespace slackwater::tests::refused_recording_test
