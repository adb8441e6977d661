// When steps begin, beside when they are due.
#include "api/door/live/punctuality.h"

#include <gtest/gtest.h>

#include <thread>

namespace slackwater::tests::punctuality_test {
namespace {

using namespace std::chrono_literals;
using live::Punctuality;

const Punctuality::WallClock::time_point noon{1000h};

TEST(Punctuality, CountsStepsThatBeginMoreThanTenMillisecondsLate) {
  Punctuality punctuality(2);
  punctuality.begin(noon, noon);
  punctuality.begin(noon + 50ms, noon + 50ms);
  punctuality.begin(noon + 100ms, noon + 109ms);
  punctuality.begin(noon + 150ms, noon + 161ms);  // 11 ms
  punctuality.begin(noon + 200ms, noon + 232ms);  // 32 ms
  punctuality.begin(noon + 250ms, noon + 251ms);  // caught up
  EXPECT_EQ(punctuality.steps(), 6U);
  EXPECT_EQ(punctuality.late_steps(), 2U);
  EXPECT_NEAR(punctuality.worst_s(), 0.032, 1e-9);
  EXPECT_EQ(punctuality.text(),
            "6 steps, 2 of them (33.3 %) began more than 10 ms late, the worst by 32.0 ms");
}

TEST(Punctuality, AStepByHandIsNeverLate) {
  Punctuality punctuality(1);
  punctuality.begin({}, noon + 60s);
  EXPECT_EQ(punctuality.text(), "no step was timed by the clock");
}

TEST(Punctuality, AsFastAsItGoesNothingIsLate) {
  Punctuality punctuality(0);
  for (int i = 0; i < 5; ++i) punctuality.begin({}, noon + i * 700ms);
  EXPECT_EQ(punctuality.late_steps(), 0U);
  EXPECT_EQ(punctuality.text(), "as fast as the machine can");
}

/// By the clock of a run, step by step as its thread asks.
struct Clocked {
  twin::RunControl control{10};  // a step of 0.1 s each 10 ms
  Punctuality punctuality{10};
  std::uint64_t step = 0;

  Clocked() { control.start_clock(0); }
  void make_step() {
    ASSERT_TRUE(control.may_step(step++, 0.1));
    punctuality.begin(control.due(), Punctuality::WallClock::now());
  }
};

TEST(Punctuality, APauseIsNoLatenessHoweverShortAndWhateverStepsAreMadeInIt) {
  Clocked run;
  for (int i = 0; i < 5; ++i) run.make_step();
  run.control.pause();
  run.control.allow_steps(3);
  for (int i = 0; i < 3; ++i) run.make_step();
  std::jthread resuming([&] {
    std::this_thread::sleep_for(300ms);
    run.control.resume();
  });
  for (int i = 0; i < 5; ++i) run.make_step();
  EXPECT_EQ(run.punctuality.steps(), 10U) << "three were by hand";
  EXPECT_LT(run.punctuality.worst_s(), 0.25);
}

TEST(Punctuality, WhoKeepsARunWaitingForSecondsMakesItLate) {
  Clocked run;
  run.make_step();
  std::this_thread::sleep_for(1200ms);
  for (int i = 0; i < 5; ++i) run.make_step();
  EXPECT_EQ(run.punctuality.late_steps(), 5U) << "all are due long since";
  EXPECT_GT(run.punctuality.worst_s(), 1.1);
}

}  // namespace
}  // namespace slackwater::tests::punctuality_test
