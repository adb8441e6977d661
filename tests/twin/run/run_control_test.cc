#include <atomic>
#include <thread>

#include "tests/twin/run/run_for_tests.h"

namespace slackwater::twin::run_control_test {
namespace {

TEST(RunControlOfARun, PausingSteppingAndResumingKeepTheBits) {
  const ReadyRun ready = tests::mixed_fleet_ready();
  constexpr std::uint64_t steps = 30;
  RunLog plain;
  twin::Run undisturbed(ready.agents, ready.states, tests::settings_of(0.05));
  tests::step_and_log(undisturbed, steps, plain);

  twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
  RunLog log;
  RunControl control;
  std::atomic<std::uint64_t> made{0};
  run.at_barrier([&](const StepTime& time) {
    log.append(static_cast<double>(time.step + 1) * 0.05, run.agents(), run.states());
    made = time.step + 1;
    if (time.step == 19) control.pause();
  });
  control.pause();
  std::jthread runner([&] { run.run_until(steps * 0.05, control); });
  const auto wait_for = [&](std::uint64_t wanted) {
    while (made < wanted) std::this_thread::yield();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_EQ(made, wanted);
  };
  wait_for(0);
  control.allow_steps(1);
  wait_for(1);
  control.allow_steps(4);
  wait_for(5);
  control.resume();
  wait_for(20);
  control.allow_steps(2);
  wait_for(22);
  control.resume();
  runner.join();
  EXPECT_EQ(run.steps_made(), steps);
  EXPECT_NEAR(run.time_s(), 1.5, 1e-12);
  tests::expect_same_bits(log, plain, "paused and resumed");
}

// Whoever pauses a run and asks for a step at once gets that one behind the step under way.
TEST(RunControlOfARun, StepsAreBehindTheOneUnderWay) {
  const ReadyRun ready = tests::mixed_fleet_ready();
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
  RunControl control;
  std::vector<std::optional<std::uint64_t>> until{control.allow_steps(1)};
  run.at_opening([&](const StepTime& time) {
    if (time.step != 6) return;
    control.pause();
    until.push_back(control.allow_steps(1));
    until.push_back(control.allow_steps(3));
  });
  std::vector<std::uint64_t> made_in_pause;
  run.at_barrier([&](const StepTime& time) {
    if (control.is_paused()) made_in_pause.push_back(time.step + 1);
    if (time.step == 10) control.resume();
  });
  run.run_until(1, control);
  until.push_back(control.allow_steps(1));
  EXPECT_EQ(until, (std::vector<std::optional<std::uint64_t>>{{}, 8, 11, {}}));
  EXPECT_EQ(made_in_pause, (std::vector<std::uint64_t>{7, 8, 9, 10, 11}));
}

TEST(RunControlOfARun, StopEndsBetweenStepsAndItGoesOnFromThere) {
  const ReadyRun ready = tests::mixed_fleet_ready();
  RunLog plain, log;
  twin::Run undisturbed(ready.agents, ready.states, tests::settings_of(0.05));
  tests::step_and_log(undisturbed, 20, plain);
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
  RunControl first;
  run.at_barrier([&](const StepTime& time) {
    log.append(static_cast<double>(time.step + 1) * 0.05, run.agents(), run.states());
    if (time.step == 6) first.stop();
  });
  run.run_until(1, first);
  EXPECT_EQ(run.steps_made(), 7U);
  RunControl second;
  run.run_until(1, second);
  EXPECT_EQ(run.steps_made(), 20U);
  tests::expect_same_bits(log, plain, "stopped and taken up again");
}

}  // namespace
}  // namespace slackwater::twin::run_control_test
