#include <functional>

#include "tests/twin/run/run_for_tests.h"

namespace slackwater::twin::same_bits_test {
namespace {

RunLog log_of(const ReadyRun& ready, const RunSettings& settings, int steps) {
  twin::Run run(ready.agents, ready.states, settings);
  RunLog log;
  tests::step_and_log(run, steps, log);
  return log;
}

/// One run, one by one on one thread, that all others are held against.
class SameBits : public testing::Test {
 protected:
  static constexpr int steps = 60;
  static void SetUpTestSuite() {
    ready_ = new ReadyRun(tests::mixed_fleet_ready());
    RunSettings settings = tests::settings_of(0.05);
    settings.is_batch = false;
    plain_ = new RunLog(log_of(*ready_, settings, steps));
  }
  static void TearDownTestSuite() {
    delete plain_;
    delete ready_;
  }
  static const ReadyRun* ready_;
  static const RunLog* plain_;
};
const ReadyRun* SameBits::ready_ = nullptr;
const RunLog* SameBits::plain_ = nullptr;

TEST_F(SameBits, EveryVehicleMovesAndNoneHalts) {
  for (std::size_t i = 0; i < plain_->rows.size(); ++i) {
    const std::vector<double> x = plain_->column(i, "x");
    EXPECT_NE(x.front(), x.back()) << i;
    for (const double halt : plain_->column(i, "halt")) ASSERT_EQ(halt, 0) << i;
  }
  EXPECT_GT(plain_->column(9, "tether_tension").back(), 0);
}

TEST_F(SameBits, InBlocksOnEveryInstructionSet) {
  RunSettings settings = tests::settings_of(0.05);
  for (const KernelPath path : supported_kernel_paths()) {
    settings.path = path;
    tests::expect_same_bits(log_of(*ready_, settings, steps), *plain_, std::string(name_of(path)));
  }
}

TEST_F(SameBits, OnAnyNumberOfThreads) {
  for (const std::size_t threads : {2U, 4U}) {
    for (const bool is_batch : {true, false}) {
      RunSettings settings = tests::settings_of(0.05);
      settings.threads = threads;
      settings.is_batch = is_batch;
      tests::expect_same_bits(log_of(*ready_, settings, steps), *plain_,
                              std::to_string(threads) + " threads");
    }
  }
}

TEST_F(SameBits, TwentyTimesOver) {
  RunSettings settings = tests::settings_of(0.05);
  settings.threads = 2;
  constexpr int few = 8;
  const RunLog first = log_of(*ready_, settings, few);
  for (int i = 1; i < 20; ++i)
    tests::expect_same_bits(log_of(*ready_, settings, few), first, "repeat " + std::to_string(i));
}

TEST_F(SameBits, WhetherTheStatesAreLookedAtOrNot) {
  twin::Run run(ready_->agents, ready_->states, tests::settings_of(0.05));
  for (int i = 0; i < steps; ++i) run.step();
  RunLog log;
  log.append(run.time_s(), run.agents(), run.states());
  for (std::size_t i = 0; i < log.rows.size(); ++i) {
    EXPECT_TRUE(tests::same_bits(log.rows[i], std::span(plain_->rows[i]).last(log_row_size())))
        << i;
  }
}

TEST_F(SameBits, WhoeverElseIsThere) {
  // Each vehicle alone, and all in the opposite order: gusts, blocks and orders of calls change;
  // what a vehicle does, not.
  std::vector<Agent> agents(ready_->agents.rbegin(), ready_->agents.rend());
  std::vector<AgentState> states(ready_->states.rbegin(), ready_->states.rend());
  ReadyRun turned;
  turned.agents = agents;
  turned.states = states;
  const RunLog log = log_of(turned, tests::settings_of(0.05), steps);
  for (std::size_t i = 0; i < agents.size(); ++i)
    EXPECT_TRUE(tests::same_bits(log.rows[i], plain_->rows[agents.size() - 1 - i])) << i;
  for (const std::size_t i : {0U, 9U, 11U, 13U, 15U, 17U}) {
    ReadyRun alone;
    alone.agents = {ready_->agents[i]};
    alone.states = {ready_->states[i]};
    const RunLog one = log_of(alone, tests::settings_of(0.05), steps);
    EXPECT_TRUE(tests::same_bits(one.rows[0], plain_->rows[i])) << i;
  }
}

TEST_F(SameBits, AnotherSeedIsAnotherGust) {
  const ReadyRun other = tests::mixed_fleet_ready(8);
  const RunLog log = log_of(other, tests::settings_of(0.05), 2);
  EXPECT_NE(log.column(13, "wind_velocity").front(), plain_->column(13, "wind_velocity").front());
}

}  // namespace
}  // namespace slackwater::twin::same_bits_test
