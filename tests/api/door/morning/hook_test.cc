// The operator's hook: told once, without a shell, for so long and no longer; and never by a file
// that others can write.
#include "api/door/morning/hook.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "api/ask/morning/operator_config.h"
#include "api/program/run_program.h"
#include "fields/base/error.h"
#include "tests/support/store_for_tests.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::hook_test {
namespace {

using api::Hook;
using std::chrono::milliseconds;

class HookTest : public testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(::chmod(folder_.path().c_str(), 0700), 0); }
  [[nodiscard]] std::filesystem::path file(const std::string& name) const {
    return folder_.path() / name;
  }
  /// A program that appends what it reads, and its arguments, to a file.
  [[nodiscard]] std::string teller(const std::string& last = "") const {
    const auto path = file("tell");
    write_bytes(path, "#!/bin/sh\nfor a in \"$@\"; do echo \"[$a]\" >> " + file("told").string() +
                          "; done\ncat >> " + file("told").string() + "\n" + last + "\n");
    EXPECT_EQ(::chmod(path.c_str(), 0700), 0);
    return path.string();
  }
  [[nodiscard]] std::string config(const std::string& yaml, mode_t mode = 0600) const {
    const auto path = file("operator.yaml");
    write_bytes(path, yaml);
    EXPECT_EQ(::chmod(path.c_str(), mode), 0);
    return path.string();
  }
  void expect_refused(const std::string& yaml, const std::string& word, mode_t mode = 0600) const {
    try {
      static_cast<void>(api::load_operator_config(config(yaml, mode)));
      FAIL() << "accepted " << yaml;
    } catch (const Error& problem) {
      EXPECT_NE(problem.message().find(word), std::string::npos) << problem.message();
    }
  }
  TemporaryFolder folder_;
};

TEST_F(HookTest, IsToldOnceOfEachForecast) {
  const Hook hook{{teller(), "a b", "$HOME; rm x"}, milliseconds(20000)};
  EXPECT_NE(api::tell_hook(hook, file("reports"), 7, "{\"verdict\": \"go\"}\n").find("was told"),
            std::string::npos);
  EXPECT_EQ(api::tell_hook(hook, file("reports"), 7, "{}"), "");
  EXPECT_EQ(read_bytes(file("told")), "[a b]\n[$HOME; rm x]\n{\"verdict\": \"go\"}\n")
      << "arguments as they are, no shell";
  EXPECT_NE(api::tell_hook(hook, file("reports"), 8, "8"), "");
}

TEST_F(HookTest, WhatFailsIsTold) {
  const auto said = api::tell_hook({{teller("echo no radio >&2; exit 3")}, milliseconds(20000)},
                                   file("reports"), 1, "{}");
  EXPECT_NE(said.find("exit code 3"), std::string::npos) << said;
  EXPECT_NE(said.find("no radio"), std::string::npos) << said;
  const auto absent =
      api::tell_hook({{file("nowhere").string()}, milliseconds(1000)}, file("reports"), 2, "{}");
  EXPECT_NE(absent.find("was not run"), std::string::npos) << absent;
}

TEST_F(HookTest, IsStoppedAtItsTimeLimitWithAllThatItStarted) {
  const auto began = std::chrono::steady_clock::now();
  const auto said =
      api::tell_hook({{teller("sleep 60 & echo $! > " + file("child").string() + "\nsleep 60")},
                      milliseconds(1500)},
                     file("reports"), 1, "{}");
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(20));
  EXPECT_NE(said.find("stopped after 1.5 s"), std::string::npos) << said;
  // What it had started in the background is gone, or waits to be laid to rest.
  const int child = std::stoi(read_bytes(file("child")));
  bool is_gone = false;
  for (int i = 0; i < 100 && !is_gone; ++i) {
    const std::string status = "/proc/" + std::to_string(child) + "/stat";
    is_gone =
        !std::filesystem::exists(status) || read_bytes(status).find(") Z") != std::string::npos;
    if (!is_gone) std::this_thread::sleep_for(milliseconds(20));
  }
  EXPECT_TRUE(is_gone);
}

TEST_F(HookTest, OneThatDoesNotReadAndOneThatLeavesThingsRunningHoldNothingUp) {
  write_bytes(file("deaf"), "#!/bin/sh\nexec 0<&-\nsleep 60 &\nexit 0\n");
  ASSERT_EQ(::chmod(file("deaf").c_str(), 0700), 0);
  const auto began = std::chrono::steady_clock::now();
  const auto end =
      api::run_program({file("deaf").string()}, std::string(1 << 20, 'x'), milliseconds(30000));
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(20));
  EXPECT_FALSE(end.is_out_of_time);
  EXPECT_EQ(end.exit_code, 0);
}

TEST_F(HookTest, HowItEndedIsHeardWhereTheEndsOfChildrenAreIgnored) {
  const auto before = std::signal(SIGCHLD, SIG_IGN);
  const auto end = api::run_program({teller("exit 7")}, "", milliseconds(20000));
  std::signal(SIGCHLD, before);
  EXPECT_FALSE(end.is_out_of_time);
  EXPECT_EQ(end.exit_code, 7);
}

TEST_F(HookTest, AProgramThatIsNotThereDoesNotUseUpItsChance) {
  const Hook absent{{file("late").string()}, milliseconds(20000)};
  EXPECT_NE(api::tell_hook(absent, file("reports"), 3, "{}").find("not run"), std::string::npos);
  std::filesystem::copy(teller(), file("late"));
  EXPECT_NE(api::tell_hook(absent, file("reports"), 3, "{}").find("was told"), std::string::npos);
}

TEST_F(HookTest, LongInputArrivesWhole) {
  const std::string input(3 << 20, 'y');
  const auto end = api::run_program({teller()}, input, milliseconds(60000));
  EXPECT_EQ(end.exit_code, 0) << end.err;
  EXPECT_EQ(read_bytes(file("told")), input);
}

TEST_F(HookTest, TheOperatorsFileIsRead) {
  const auto found = api::load_operator_config(
      config("hook:\n  command: [/bin/true, --now]\n  time_limit_s: 5\n"));
  ASSERT_TRUE(found.hook);
  EXPECT_EQ(found.hook->command, (std::vector<std::string>{"/bin/true", "--now"}));
  EXPECT_EQ(found.hook->limit, milliseconds(5000));
  EXPECT_FALSE(api::load_operator_config(config("{}\n")).hook);
}

TEST_F(HookTest, AFileThatOthersCanWriteStartsNothing) {
  const std::string yaml = "hook:\n  command: [/bin/true]\n";
  expect_refused(yaml, "writable for others", 0666);
  expect_refused(yaml, "writable for others", 0620);
  ASSERT_EQ(::chmod(folder_.path().c_str(), 0777), 0);
  expect_refused(yaml, "writable for others");  // another file could be put in its place
  ASSERT_EQ(::chmod(folder_.path().c_str(), 0700), 0);
  EXPECT_TRUE(api::load_operator_config(config(yaml)).hook);
}

TEST_F(HookTest, AProgramThatOthersCanWriteIsNotRun) {
  const std::string yaml = "hook:\n  command: [" + teller() + "]\n";
  EXPECT_TRUE(api::load_operator_config(config(yaml)).hook);
  ASSERT_EQ(::chmod(file("tell").c_str(), 0777), 0);
  expect_refused(yaml, "tell writable for others");
}

TEST_F(HookTest, ALinkIsFollowedAndItsFolderLookedAt) {
  const auto open_folder = folder_.path() / "open";
  ASSERT_TRUE(std::filesystem::create_directory(open_folder));
  static_cast<void>(config("hook:\n  command: [/bin/true]\n"));
  std::filesystem::create_symlink(file("operator.yaml"), open_folder / "link.yaml");
  ASSERT_EQ(::chmod(open_folder.c_str(), 0700), 0);
  EXPECT_TRUE(api::load_operator_config(open_folder / "link.yaml").hook);
  // A link to that link, from a folder that nobody else writes.
  std::filesystem::create_symlink(open_folder / "link.yaml", file("far.yaml"));
  EXPECT_TRUE(api::load_operator_config(file("far.yaml")).hook);
  ASSERT_EQ(::chmod(open_folder.c_str(), 0777), 0);
  for (const auto& way : {open_folder / "link.yaml", file("far.yaml")})
    EXPECT_THROW(static_cast<void>(api::load_operator_config(way)), Error) << way;
}

TEST_F(HookTest, WhatCannotBeRunAsItStandsIsRefused) {
  expect_refused("hook:\n  command: tell\n", "list");
  expect_refused("hook:\n  command: []\n", "list");
  expect_refused("hook:\n  command: [tell]\n", "absolute path");
  expect_refused("hook:\n  command: [/bin/true]\n  time_limit_s: 0\n", "time_limit_s");
  expect_refused("hoook: {}\n", "hoook");
}

}  // namespace
}  // namespace slackwater::tests::hook_test
