#include "tests/bench/counted_allocations.h"
#include "tests/twin/run/helm_for_tests.h"
#include "twin/control/velocity_range.h"
#include "twin/vehicle/actuator_channels.h"

namespace slackwater::tests::helm_same_bits_test {
namespace {

using twin::Command;

constexpr int steps = 120;

/// A command of each kind, from three sources, all over the fleet; some vehicles fall silent.
void say_something(twin::Run& run, std::uint64_t step, std::vector<std::uint64_t>& sequence) {
  const char* const sources[] = {"dds 01", "http 7", "mavlink 255"};
  const std::size_t agent = (7 * step) % run.agents().size();
  const twin::Agent& who = run.agents()[agent];
  Command command{step,
                  agent,
                  {},
                  sources[step % 3],
                  ++sequence[step % 3],
                  static_cast<double>(step) * helm_step_s};
  const auto& at = run.seen(agent).position_m;
  switch (step % 6) {
    case 0:
    case 1:
      command.what =
          twin::SetVelocity{{0.5 * twin::velocity_range(*who.autopilot).most_ahead_m_s, 0, 0, 0.1}};
      break;
    case 2:
      if (step % 12 == 2) {
        command.what = twin::SetThrusters{std::vector<double>(who.vehicle->mounts, 0.4)};
      } else {
        twin::SetActuators set;
        for (std::size_t i = 0; i < twin::most_channels; ++i)
          if (twin::channel_of(*who.vehicle, i)) set.given.give(i, 0.3);
        command.what = set;
      }
      break;
    case 3:
      command.what = twin::Reroute{{{{at.x + 5, at.y, at.z}, 0}, {{at.x, at.y, at.z}, 0}}, true};
      break;
    case 4:
      command.what = twin::HoldHere{step % 12 == 4};
      break;
    default:
      command.what = step % 12 == 5 ? twin::CommandWhat{twin::GoHome{}} : twin::Resume{};
  }
  run.enqueue(std::move(command));
}

struct Made {
  twin::RunLog log;
  std::vector<twin::AgentState> states;
  std::vector<Command> taken;
};

Made made(twin::Run& run, int for_steps) {
  Made out;
  step_and_log(run, for_steps, out.log);
  out.states.assign(run.states().begin(), run.states().end());
  out.taken.assign(run.commands_taken().begin(), run.commands_taken().end());
  return out;
}

std::unique_ptr<twin::Run> driven(const twin::ReadyRun& ready, std::vector<std::uint64_t>& count) {
  auto run = begun(ready, helm_step_s);
  run->at_opening([&count, &driven = *run](const twin::StepTime& time) {
    say_something(driven, time.step, count);
  });
  return run;
}

void expect_same(const Made& a, const Made& b, const std::string& what) {
  expect_same_bits(a.log, b.log, what);
  for (std::size_t i = 0; i < a.states.size(); ++i) {
    const auto &v = a.states[i].vehicle, &w = b.states[i].vehicle;
    EXPECT_EQ(std::memcmp(&v, &w, sizeof v), 0) << what << ": vehicle " << i;
    EXPECT_EQ(a.states[i].helm.mode, b.states[i].helm.mode) << what << ": vehicle " << i;
  }
}

TEST(HelmSameBits, CommandsOfThreeSourcesAreMadeAgainByTheirRecord) {
  const twin::ReadyRun ready = mixed_fleet_ready();
  std::vector<std::uint64_t> count(3);
  const Made first = made(*driven(ready, count), steps);
  ASSERT_EQ(first.taken.size(), static_cast<std::size_t>(steps));
  for (std::size_t i = 0; i < first.taken.size(); ++i)
    ASSERT_EQ(first.taken[i].step, i) << "what an opening says is for that very step";
  for (const std::size_t threads : {1U, 2U})
    for (const bool is_batch : {true, false}) {
      const auto again = begun(ready, helm_step_s, threads, is_batch);
      for (const Command& command : first.taken) again->enqueue(command);
      const Made second = made(*again, steps);
      expect_same(second, first,
                  std::to_string(threads) + (is_batch ? " in blocks" : " one by one"));
      for (std::size_t i = 0; i < first.taken.size(); ++i) {
        ASSERT_EQ(second.taken[i].source, first.taken[i].source);
        ASSERT_EQ(second.taken[i].sequence, first.taken[i].sequence);
        ASSERT_EQ(second.taken[i].received_s, first.taken[i].received_s);
      }
    }
}

TEST(HelmSameBits, ACheckpointInTheMiddleGoesOnAsTheRunWouldHave) {
  const twin::ReadyRun ready = mixed_fleet_ready();
  std::vector<std::uint64_t> count(3), other(3);
  const auto run = driven(ready, count);
  (void)made(*run, 50);
  const twin::Run::Checkpoint checkpoint = run->checkpoint();
  const Made rest = made(*run, steps - 50);
  for (const bool is_batch : {true, false}) {
    const auto second = begun(ready, helm_step_s, 2, is_batch);
    second->restore(checkpoint);
    for (std::size_t i = 50; i < rest.taken.size(); ++i) second->enqueue(rest.taken[i]);
    expect_same(made(*second, steps - 50), rest, is_batch ? "in blocks" : "one by one");
  }
}

TEST(HelmSameBits, AStepWithoutCommandsAllocatesNothingUnderTheHelm) {
  const twin::ReadyRun ready = mixed_fleet_ready();
  const auto run = begun(ready, helm_step_s);
  for (std::size_t i = 0; i < run->agents().size(); ++i) {
    const twin::Agent& who = run->agents()[i];
    Command command{0, i, twin::HoldHere{}};
    if (i % 4 == 0) command.what = twin::SetVelocity{{0.3, 0, 0, 0.1}};
    if (i % 4 == 1)
      command.what = twin::SetThrusters{std::vector<double>(who.vehicle->mounts, 0.4)};
    const auto& at = run->seen(i).position_m;
    if (i % 4 == 2)
      command.what = twin::Reroute{{{{at.x + 0.1, at.y, at.z}, 0}, {{at.x, at.y, at.z}, 0}}, true};
    run->enqueue(std::move(command));
  }
  for (int i = 0; i < 5; ++i) run->step();
  const std::size_t before = bench::allocations();
  // Past the time-out too, which is a hold for half of them.
  for (int i = 0; i < 100; ++i) run->step();
  EXPECT_EQ(bench::allocations(), before);
  EXPECT_EQ(run->helm(0).cause, twin::HelmCause::not_renewed);
}

}  // namespace
}  // namespace slackwater::tests::helm_same_bits_test
