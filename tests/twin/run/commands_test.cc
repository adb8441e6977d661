#include <atomic>
#include <thread>

#include "fields/base/check.h"
#include "tests/twin/run/run_for_tests.h"

namespace slackwater::twin::commands_test {
namespace {

constexpr int steps = 80;

struct Made {
  RunLog log;
  std::vector<AgentState> states;
};

Made make(twin::Run& run) {
  Made made;
  tests::step_and_log(run, steps, made.log);
  made.states.assign(run.states().begin(), run.states().end());
  return made;
}

void expect_same(const Made& a, const Made& b, const std::string& what) {
  tests::expect_same_bits(a.log, b.log, what);
  for (std::size_t i = 0; i < a.states.size(); ++i) {
    const VehicleState<double>&v = a.states[i].vehicle, &w = b.states[i].vehicle;
    EXPECT_EQ(std::memcmp(&v, &w, sizeof v), 0) << what << ": vehicle " << i;
  }
}

Made made_again(const ReadyRun& ready, std::span<const Command> record, std::size_t threads,
                bool is_batch) {
  RunSettings settings = tests::settings_of(0.05);
  settings.threads = threads;
  settings.is_batch = is_batch;
  twin::Run run(ready.agents, ready.states, settings);
  for (const Command& command : record) run.enqueue(command);
  return make(run);
}

Waypoint beside(const AgentState& state, double north_m, double east_m) {
  const Triple<double>& at = state.vehicle.body.position_m;
  return {{at.x + north_m, at.y + east_m, at.z}, 0};
}

TEST(Commands, ARunDrivenFromAnotherThreadIsMadeAgainByItsRecord) {
  const ReadyRun ready = tests::mixed_fleet_ready();
  const RunLog undisturbed = made_again(ready, {}, 1, true).log;
  for (const std::size_t threads : {1U, 2U}) {
    RunSettings settings = tests::settings_of(0.05);
    settings.threads = threads;
    twin::Run run(ready.agents, ready.states, settings);
    std::atomic<bool> has_begun = false, is_over = false;
    std::thread people([&] {
      for (std::size_t i = 0; !is_over && i < 2000; ++i) {
        const std::size_t agent = (7 * i) % ready.agents.size();
        const AgentState& first = ready.states[agent];
        Command command{0, agent, Reroute{{beside(first, 20, -10), beside(first, 5, 30)}}};
        if (i % 3 == 1) {
          VehicleState<double> nudged = first.vehicle;
          nudged.body.position_m.x += 0.5;
          command.what = PutVehicle{nudged};
        }
        run.enqueue(command);
        has_begun = true;
        std::this_thread::sleep_for(std::chrono::microseconds(200));
      }
    });
    while (!has_begun) std::this_thread::yield();
    const Made driven = make(run);
    is_over = true;
    people.join();
    const std::vector<Command> record(run.commands_taken().begin(), run.commands_taken().end());
    EXPECT_GT(record.size(), 1U);
    EXPECT_FALSE(tests::same_bits(driven.log.rows[0], undisturbed.rows[0]));
    expect_same(made_again(ready, record, 1, true), driven, "on one thread");
    expect_same(made_again(ready, record, 2, true), driven, "on two");
    expect_same(made_again(ready, record, 1, false), driven, "one by one");
  }
}

TEST(Commands, TakeEffectByTheirStepAndThenAsTheyCame) {
  const ReadyRun ready = tests::mixed_fleet_ready();
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
  const AgentState& first = ready.states[0];
  for (int i = 0; i < 3; ++i) run.step();
  run.enqueue({5, 0, Reroute{{beside(first, 1, 0)}}});
  run.enqueue({4, 1, Reroute{}});
  run.enqueue({5, 0, Reroute{{beside(first, 2, 0)}}});
  run.enqueue({2, 2, Reroute{}});  // that step is made: the next one
  EXPECT_TRUE(run.commands_taken().empty());
  for (int i = 0; i < 3; ++i) run.step();
  const std::span<const Command> taken = run.commands_taken();
  ASSERT_EQ(taken.size(), 4U);
  const std::vector<std::pair<std::uint64_t, std::size_t>> expected{{3, 2}, {4, 1}, {5, 0}, {5, 0}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(taken[i].step, expected[i].first) << i;
    EXPECT_EQ(taken[i].agent, expected[i].second) << i;
  }
  // The second of two for the same vehicle is the one that it follows.
  EXPECT_EQ(run.states()[0].helm.way.route.to().position_m.x, beside(first, 2, 0).position_m.x);
}

TEST(Commands, ACheckpointHasThoseThatWaitAndThoseThatWereTaken) {
  const ReadyRun ready = tests::mixed_fleet_ready();
  const std::vector<Command> commands{{10, 3, Reroute{{beside(ready.states[3], 9, 9)}}},
                                      {40, 4, Reroute{{beside(ready.states[4], -9, 9)}}}};
  twin::Run whole(ready.agents, ready.states, tests::settings_of(0.05));
  for (const Command& command : commands) whole.enqueue(command);
  RunLog skipped, expected, got;
  tests::step_and_log(whole, 20, skipped);
  const twin::Run::Checkpoint checkpoint = whole.checkpoint();
  tests::step_and_log(whole, 40, expected);
  EXPECT_EQ(whole.commands_taken().size(), 2U);

  twin::Run second(ready.agents, ready.states, tests::settings_of(0.05));
  second.enqueue({25, 5, Reroute{}});  // forgotten
  second.restore(checkpoint);
  EXPECT_EQ(second.commands_taken().size(), 1U);
  tests::step_and_log(second, 40, got);
  tests::expect_same_bits(got, expected, "another run");
  ASSERT_EQ(second.commands_taken().size(), 2U);
  EXPECT_EQ(second.commands_taken()[1].step, 40U);

  RunLog again;
  whole.restore(checkpoint);
  EXPECT_EQ(whole.commands_taken().size(), 1U);
  tests::step_and_log(whole, 40, again);
  tests::expect_same_bits(again, expected, "the same run, back");
}

TEST(Commands, AVehicleThatHaltedStaysAsItIs) {
  ReadyRun ready = tests::mixed_fleet_ready();
  halt(ready.states[2], Halt::aground, 0);
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
  run.enqueue({0, 2, PutVehicle{ready.states[3].vehicle}});
  run.enqueue({0, 2, Reroute{}});
  run.step();
  EXPECT_EQ(run.commands_taken().size(), 2U);
  EXPECT_EQ(run.states()[2].vehicle.body.position_m.y, ready.states[2].vehicle.body.position_m.y);
  EXPECT_FALSE(run.states()[2].helm.is_helmed());
}

TEST(Commands, OneThatNoVehicleCanFollowIsABug) {
  const ReadyRun ready = tests::mixed_fleet_ready();
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
  EXPECT_THROW(run.enqueue({0, ready.agents.size(), Reroute{}}), ContractViolation);
  EXPECT_THROW(run.enqueue({0, 0, Reroute{{{{0, std::nan(""), 0}, 1}}}}), ContractViolation);
  run.step();
  EXPECT_TRUE(run.commands_taken().empty());
}

TEST(Commands, AVehicleThatGoesByItsInstrumentsIsReroutedFromWhereItTakesItselfToBe) {
  const ReadyRun ready = tests::ready_of(tests::head(0.05) +
                                         "  - {name: usv, model: wamv16, navigation: sensors, "
                                         "start: {north_m: 0, east_m: 0, depth_m: 0}, "
                                         "tasks: [{do: hold}]}\n");
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
  for (int i = 0; i < 10; ++i) run.step();
  const Triple<double> taken_for = run.states()[0].navigation.navigator.position_m;
  EXPECT_NE(taken_for.x, run.states()[0].vehicle.body.position_m.x);
  run.enqueue({0, 0, Reroute{{{{80, 20, 0}, 0}}}});
  run.step();
  const Triple<double>& from = run.states()[0].helm.way.route.from();
  EXPECT_EQ(from.x, taken_for.x);
  EXPECT_EQ(from.y, taken_for.y);
}

}  // namespace
}  // namespace slackwater::twin::commands_test
