// Work that may die, in a process of its own: whatever it does to itself, we live and are told.
#include "fields/base/process/run_apart.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <fstream>
#include <new>
#include <stdexcept>
#include <thread>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace slackwater::tests::run_apart_test {
namespace {

using std::chrono::seconds;

Apart run(const std::function<std::string(const TellShare&)>& work,
          const Allowance& allowance = {}) {
  return run_apart(allowance, work, {});
}

TEST(RunApart, AnswersAndSharesComeBackWhole) {
  const std::string long_answer(3 << 20, 'x');
  std::vector<double> shares;
  const Apart apart = run_apart(
      {},
      [&](const TellShare& tell) {
        for (int i = 0; i <= 1000; ++i) tell(0.001 * i);
        return long_answer;
      },
      [&](double share) { shares.push_back(share); });
  EXPECT_EQ(apart.end, Apart::End::answered);
  EXPECT_EQ(apart.answer, long_answer);
  ASSERT_GE(shares.size(), 900U);
  EXPECT_NEAR(shares.back(), 1, 1e-3);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
}

TEST(RunApart, AnEmptyAnswerIsAnAnswer) {
  const Apart apart = run([](const TellShare&) { return std::string(); });
  EXPECT_EQ(apart.end, Apart::End::answered);
  EXPECT_EQ(apart.answer, "");
}

TEST(RunApart, WhatItChangesInMemoryStaysThere) {
  int count = 1;
  EXPECT_EQ(run([&](const TellShare&) { return std::to_string(++count); }).answer, "2");
  EXPECT_EQ(count, 1);
}

TEST(RunApart, ACrashIsToldWithItsSignal) {
  for (const int signal : {SIGABRT, SIGFPE, SIGSEGV, SIGBUS}) {
    const Apart apart = run([=](const TellShare& tell) {
      tell(0.5);
      std::signal(signal, SIG_DFL);  // a sanitizer's own handler apart
      ::raise(signal);
      return std::string("never");
    });
    EXPECT_EQ(apart.end, Apart::End::crashed) << signal;
    EXPECT_EQ(apart.signal, signal);
    EXPECT_EQ(apart.answer, "");
  }
}

TEST(RunApart, AnEndWithoutAnAnswerIsACrash) {
  const Apart left = run([](const TellShare&) -> std::string { ::_exit(0); });
  EXPECT_EQ(left.end, Apart::End::crashed);
  EXPECT_EQ(left.signal, 0);
  const Apart thrown = run([](const TellShare&) -> std::string { throw std::runtime_error("no"); });
  EXPECT_EQ(thrown.end, Apart::End::crashed);
}

TEST(RunApart, AnEndFromOutsideIsNoCrash) {
  const Apart apart = run([](const TellShare&) {
    ::raise(SIGKILL);
    return std::string();
  });
  EXPECT_EQ(apart.end, Apart::End::killed);
  EXPECT_EQ(apart.signal, SIGKILL);
}

TEST(RunApart, WhatNeverEndsIsEndedWhenItsProcessorTimeIsUsedUp) {
  Allowance allowance;
  allowance.processor = seconds(1);
  const Apart apart = run(
      [](const TellShare&) {
        volatile bool goes_on = true;
        while (goes_on) {
        }
        return std::string();
      },
      allowance);
  EXPECT_EQ(apart.end, Apart::End::out_of_time);
}

/// Whether a process is gone, or dead and not yet buried.
bool is_dead(pid_t process) {
  std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
  std::string number;
  std::string name;
  std::string state;
  return !(stat >> number >> name >> state) || state == "Z" || state == "X";
}

TEST(RunApart, TheChildGoesWithItsParent) {
  for (const int signal : {SIGINT, SIGKILL}) {
    const TemporaryFolder folder;
    const pid_t parent = ::fork();
    if (parent == 0) {
      Allowance allowance;
      allowance.reach.writable = {folder.path()};
      static_cast<void>(run(
          [&](const TellShare&) {
            std::ofstream(folder / "child") << ::getpid() << std::endl;
            ::sleep(60);
            return std::string();
          },
          allowance));
      ::_exit(0);
    }
    pid_t child = 0;
    for (int turn = 0; turn < 1000 && child == 0; ++turn) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      std::ifstream(folder / "child") >> child;
    }
    ASSERT_GT(child, 0);
    EXPECT_FALSE(is_dead(child));
    ::kill(parent, signal);
    ::waitpid(parent, nullptr, 0);
    for (int turn = 0; turn < 500 && !is_dead(child); ++turn)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_TRUE(is_dead(child)) << signal;
  }
}

TEST(RunApart, WhatWaitsForEverIsEndedByTheClock) {
  Allowance allowance;
  allowance.processor = seconds(0);
  const Apart apart = run(
      [](const TellShare&) {
        ::sleep(600);
        return std::string();
      },
      allowance);
  EXPECT_EQ(apart.end, Apart::End::out_of_time);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(RunApart, AddressesBeyondTheAllowanceAreRefusedInTheChildAlone) {
  Allowance allowance;
  allowance.memory_bytes = std::uint64_t{2} << 30U;
  const Apart apart = run(
      [](const TellShare&) -> std::string {
        try {
          const std::vector<char> all(std::size_t{3} << 30U);
          return "had " + std::to_string(all.size());
        } catch (const std::bad_alloc&) {
          return "refused";
        }
      },
      allowance);
  EXPECT_EQ(apart.answer, "refused");
  struct rlimit ours {};
  ASSERT_EQ(::getrlimit(RLIMIT_AS, &ours), 0);
  EXPECT_GT(ours.rlim_cur, allowance.memory_bytes);
}
#endif

/// Takes memory bit by bit, and uses it.
std::string take_memory(const TellShare&) {
  std::vector<std::vector<char>> all;
  for (std::size_t i = 0; i < 700; ++i) {
    all.emplace_back(std::size_t{1} << 20U, 'x');
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return std::to_string(all.size());
}

// One that says a word now and then is as late as one that says nothing.
TEST(RunApart, WhoNeverStopsTellingIsEndedByTheClockToo) {
  Allowance allowance;
  allowance.processor = seconds(0);
  const Apart apart = run(
      [](const TellShare& tell) {
        for (int i = 0; i < 600; ++i) {
          tell(0.001 * i);
          std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
        return std::string();
      },
      allowance);
  EXPECT_EQ(apart.end, Apart::End::out_of_time);
}

TEST(RunApart, WhoHangsUpAndStaysIsEnded) {
  const auto begun = std::chrono::steady_clock::now();
  const Apart apart = run([](const TellShare&) {
    for (int each = 3; each < 100; ++each) ::close(each);
    ::sleep(600);
    return std::string();
  });
  EXPECT_EQ(apart.end, Apart::End::killed);
  EXPECT_LT(std::chrono::steady_clock::now() - begun, seconds(120));
}

TEST(RunApart, IsAloneAgainOnceAThreadHasEnded) {
  EXPECT_EQ(run([](const TellShare&) { return std::string("x"); }).answer, "x");
  EXPECT_TRUE(is_alone());
  std::atomic<bool> ends = false;
  std::thread thread([&] {
    while (!ends) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  });
  EXPECT_FALSE(is_alone());
  ends = true;
  thread.join();
  EXPECT_TRUE(is_alone());
}

TEST(RunApart, WhoeverUsesMoreMemoryThanItMayIsEnded) {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "bounded by its addresses already";
#endif
  Allowance allowance;
  allowance.memory_bytes = std::uint64_t{512} << 20U;
  EXPECT_EQ(run(take_memory, allowance).end, Apart::End::out_of_memory);
  allowance.memory_bytes = std::uint64_t{8} << 30U;
  EXPECT_EQ(run(take_memory, allowance).answer, "700");
}

TEST(RunApart, WhoeverWritesMoreToAFileThanItMayIsEnded) {
  const TemporaryFolder folder;
  Allowance allowance;
  allowance.file_bytes = 1 << 20U;
  allowance.reach.writable = {folder.path()};
  const auto write = [&](std::size_t bytes) {
    return run(
        [&](const TellShare&) {
          std::ofstream file(folder / "file");
          file << std::string(bytes, 'x');
          file.close();
          return std::string(file ? "written" : "refused");
        },
        allowance);
  };
  EXPECT_EQ(write(1 << 20U).answer, "written");
  EXPECT_EQ(write((1 << 20U) + 1).end, Apart::End::wrote_too_much);
}

TEST(RunApart, WhatIsDoneMeanwhileIsDoneHere) {
  int count = 1;
  const Apart apart = run_apart(
      {}, [&](const TellShare&) { return std::to_string(count); }, {}, [&] { ++count; });
  EXPECT_EQ(apart.answer, "1");
  EXPECT_EQ(count, 2);
}

// And leaves no process behind.
TEST(RunApart, WhatGoesWrongMeanwhileIsThrownHere) {
  EXPECT_THROW(static_cast<void>(run_apart(
                   {},
                   [](const TellShare&) {
                     ::sleep(600);
                     return std::string();
                   },
                   {}, [] { throw std::runtime_error("no"); })),
               std::runtime_error);
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
}

}  // namespace
}  // namespace slackwater::tests::run_apart_test
