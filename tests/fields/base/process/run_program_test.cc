// Programs that say much, hang, die, leave others behind or are not there.
#include "fields/base/process/run_program.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <thread>

#include "tests/support/temporary_folder.h"

namespace slackwater::run_program_test {
namespace {

using End = ProgramEnded::End;

ProgramAsked shell(const std::string& script) {
  ProgramAsked asked;
  asked.arguments = {"sh", "-c", script};
  asked.environment = {"PATH=/usr/bin:/bin"};
  asked.longest = std::chrono::seconds(20);
  return asked;
}

double took_s(const ProgramAsked& asked, ProgramEnded& ended,
              const std::atomic<bool>* stop = nullptr) {
  const auto began = std::chrono::steady_clock::now();
  ended = run_program(asked, stop);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

TEST(RunProgram, TellsWhatItSaidAndHowItEnded) {
  const ProgramEnded ended = run_program(shell("echo out; echo err >&2; exit 7"));
  EXPECT_EQ(ended.end, End::exited);
  EXPECT_EQ(ended.status, 7);
  EXPECT_EQ(ended.output, "out\nerr\n");
}

TEST(RunProgram, HasItsArgumentsAsTheyAreAndNoShellBetween) {
  ProgramAsked asked = shell("");
  asked.arguments = {"printf", "%s|", "a b", "$HOME", "; touch x", "*"};
  EXPECT_EQ(run_program(asked).output, "a b|$HOME|; touch x|*|");
}

TEST(RunProgram, HasTheEnvironmentThatIsGivenAndNoOther) {
  setenv("SLACKWATER_TEST_SECRET", "1234", 1);
  ProgramAsked asked = shell("env");
  asked.environment.emplace_back("GIVEN=yes");
  const std::string said = run_program(asked).output;
  unsetenv("SLACKWATER_TEST_SECRET");
  EXPECT_NE(said.find("GIVEN=yes\n"), std::string::npos) << said;
  EXPECT_EQ(said.find("SLACKWATER_TEST_SECRET"), std::string::npos) << said;
}

TEST(RunProgram, WorksInItsFolderAndReadsNothing) {
  const tests::TemporaryFolder folder;
  ProgramAsked asked = shell("cat; echo here > made; ls /proc/self/fd");
  asked.folder = folder / "";
  // 0, 1, 2 and that of `ls` itself.
  EXPECT_EQ(run_program(asked).output, "0\n1\n2\n3\n");
  EXPECT_TRUE(std::filesystem::exists(folder / "made"));
}

TEST(RunProgram, KeepsTheLastOfWhatItSays) {
  ProgramAsked asked = shell("seq 1 200000");
  asked.most_output = 1000;
  const ProgramEnded ended = run_program(asked);
  EXPECT_EQ(ended.output.size(), 1000U);
  EXPECT_TRUE(ended.output.ends_with("199999\n200000\n"));
}

TEST(RunProgram, IsEndedWhereItHangsWithAllThatItStarted) {
  const tests::TemporaryFolder folder;
  ProgramAsked asked =
      shell("trap '' TERM; (trap '' TERM; sleep 100) & echo $! > child; sleep 100");
  asked.folder = folder / "";
  asked.longest = std::chrono::seconds(1);
  ProgramEnded ended;
  const double lasted_s = took_s(asked, ended);
  EXPECT_EQ(ended.end, End::out_of_time);
  EXPECT_LT(lasted_s, 12) << "a second, five of grace, and a slow machine";
  pid_t child = 0;
  std::ifstream(folder / "child") >> child;
  ASSERT_GT(child, 0);
  // Nobody waits for it but init: it may be a zombie for a moment.
  for (int i = 0; i < 50 && kill(child, 0) == 0; ++i) {
    std::ifstream stat("/proc/" + std::to_string(child) + "/stat");
    std::string all{std::istreambuf_iterator<char>(stat), {}};
    if (all.empty() || all.find(") Z") != std::string::npos) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    EXPECT_LT(i, 49) << all;
  }
}

TEST(RunProgram, DoesNotWaitForWhatItLeavesBehind) {
  ProgramEnded ended;
  EXPECT_LT(took_s(shell("sleep 100 & echo done"), ended), 10);
  EXPECT_EQ(ended.end, End::exited);
  EXPECT_EQ(ended.output, "done\n");
}

TEST(RunProgram, IsEndedThoughItWritesWithoutEnd) {
  ProgramAsked asked = shell("");
  asked.arguments = {"yes"};
  asked.longest = std::chrono::seconds(1);
  ProgramEnded ended;
  EXPECT_LT(took_s(asked, ended), 12);
  EXPECT_EQ(ended.end, End::out_of_time);
}

TEST(RunProgram, IsNotTakenFromTheFolderThatItWorksIn) {
  const tests::TemporaryFolder folder;
  std::ofstream(folder / "made-up-tool") << "#!/bin/sh\necho taken\n";
  std::filesystem::permissions(folder / "made-up-tool", std::filesystem::perms::owner_all);
  ProgramAsked asked = shell("");
  asked.arguments = {"made-up-tool"};
  asked.folder = folder / "";
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder / "");
  const ProgramEnded ended = run_program(asked);
  std::filesystem::current_path(before);
  EXPECT_EQ(ended.end, End::not_found) << ended.output;
}

TEST(RunProgram, HasNoTerminalToAskAPersonAt) {
  EXPECT_EQ(run_program(shell("if (: < /dev/tty) 2>/dev/null; then echo asks; fi")).output, "");
}

TEST(RunProgram, IsStoppedWhenThatIsAsked) {
  std::atomic<bool> stop = false;
  std::thread asks([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    stop = true;
  });
  ProgramEnded ended;
  const double lasted_s = took_s(shell("sleep 100"), ended, &stop);
  asks.join();
  EXPECT_EQ(ended.end, End::stopped);
  EXPECT_LT(lasted_s, 10);
}

TEST(RunProgram, SaysOfWhatSignalItDied) {
  const ProgramEnded ended = run_program(shell("kill -SEGV $$"));
  EXPECT_EQ(ended.end, End::killed);
  EXPECT_EQ(ended.signal, SIGSEGV);
}

TEST(RunProgram, IsToldOfOneThatIsNotThere) {
  ProgramAsked asked = shell("");
  for (const char* name : {"no-such-program", "/no/such/program", "/etc/passwd"}) {
    asked.arguments = {name};
    EXPECT_EQ(run_program(asked).end, End::not_found) << name;
  }
}

TEST(RunProgram, HasNoMoreMemoryThanItMay) {
  ProgramAsked asked = shell("head -c 900000000 /dev/zero | tail -c 800000000 | wc -c");
  asked.memory_bytes = std::uint64_t{200} << 20U;
  const ProgramEnded ended = run_program(asked);
  EXPECT_EQ(ended.output.find("800000000"), std::string::npos) << ended.output;
}

}  // namespace
}  // namespace slackwater::run_program_test
