// One question, one answer, in time or not at all.
#include "api/door/live/lock_step.h"

#include <gtest/gtest.h>

#include <thread>

namespace slackwater::tests::lock_step_test {
namespace {

using namespace std::chrono_literals;

bool never() { return false; }

TEST(LockStep, TheAnswerToTheStepThatIsAskedIsTaken) {
  live::LockStep<int> lock;
  lock.ask(5);
  EXPECT_TRUE(lock.answer(5, 50));
  EXPECT_EQ(lock.wait(1s, never), 50) << "it came before anybody waited";
}

TEST(LockStep, LateAndEarlyAnswersAreDropped) {
  live::LockStep<int> lock;
  EXPECT_FALSE(lock.answer(4, 40)) << "nobody asked";
  lock.ask(5);
  EXPECT_FALSE(lock.answer(4, 40));
  EXPECT_FALSE(lock.answer(6, 60));
  EXPECT_EQ(lock.wait(1ms, never), std::nullopt);
  EXPECT_FALSE(lock.answer(5, 50)) << "nobody waits any more";
  lock.ask(6);
  EXPECT_EQ(lock.wait(1ms, never), std::nullopt) << "nothing is left of the step before";
}

TEST(LockStep, NobodyIsWaitedForWhenTheRunIsStopped) {
  live::LockStep<int> lock;
  std::atomic<bool> is_stopped = false;
  std::jthread stopping([&] {
    std::this_thread::sleep_for(50ms);
    is_stopped = true;
  });
  lock.ask(5);
  const auto begun = std::chrono::steady_clock::now();
  EXPECT_EQ(lock.wait(600s, [&] { return is_stopped.load(); }), std::nullopt);
  EXPECT_LT(std::chrono::steady_clock::now() - begun, 60s);
}

TEST(LockStep, NobodyIsWaitedForWhoIsGivenUp) {
  live::LockStep<int> lock;
  lock.ask(5);
  std::jthread gone([&] {
    std::this_thread::sleep_for(50ms);
    lock.give_up();
  });
  const auto begun = std::chrono::steady_clock::now();
  EXPECT_EQ(lock.wait(600s, never), std::nullopt);
  EXPECT_LT(std::chrono::steady_clock::now() - begun, 60s);
  gone.join();
  lock.ask(6);
  EXPECT_TRUE(lock.answer(6, 60));
  EXPECT_EQ(lock.wait(1s, never), 60) << "the next one is waited for";
}

TEST(LockStep, AThousandStepsWithAnotherThread) {
  live::LockStep<std::uint64_t> lock;
  std::atomic<std::uint64_t> asked{0};
  std::jthread other([&](const std::stop_token& over) {
    for (std::uint64_t answered = 0; !over.stop_requested();) {
      const std::uint64_t step = asked;
      if (step > answered && lock.answer(step, 10 * step)) answered = step;
    }
  });
  for (std::uint64_t step = 1; step <= 1000; ++step) {
    lock.ask(step);
    asked = step;
    ASSERT_EQ(lock.wait(20s, never), 10 * step);
  }
}

}  // namespace
}  // namespace slackwater::tests::lock_step_test
