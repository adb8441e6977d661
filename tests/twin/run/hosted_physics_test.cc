#include "tests/twin/run/helm_for_tests.h"
#include "twin/step/vehicle_step.h"

namespace slackwater::tests::hosted_physics_test {
namespace {

using twin::HostedStep;
using twin::VehicleState;

/// Our own physics of a vehicle of one step a barrier, made elsewhere.
std::optional<VehicleState<double>> own_physics(const HostedStep& hosted) {
  VehicleState<double> next = hosted.state.vehicle;
  twin::step(*hosted.agent.vehicle, hosted.agent.plan, next, hosted.input.command,
             hosted.input.around);
  return next;
}

struct Made {
  twin::RunLog log;
  std::vector<twin::Command> taken;
};

Made made(twin::Run& run, int steps) {
  Made out;
  step_and_log(run, steps, out.log);
  out.taken.assign(run.commands_taken().begin(), run.commands_taken().end());
  return out;
}

/// Vehicles of the mixed fleet that make one step a barrier.
std::vector<std::size_t> to_be_hosted(const twin::Run& run) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < run.agents().size(); ++i)
    if (run.agents()[i].steps_per_barrier == 1) out.push_back(i);
  return out;
}

TEST(HostedPhysics, OurOwnMadeElsewhereGiveTheSameBits) {
  const twin::ReadyRun ready = mixed_fleet_ready();
  const Made own = made(*begun(ready, helm_step_s), 60);
  for (const bool is_batch : {true, false}) {
    const auto run = begun(ready, helm_step_s, 1, is_batch);
    const std::vector<std::size_t> hosted = to_be_hosted(*run);
    ASSERT_GT(hosted.size(), 5U);
    for (const std::size_t i : hosted) {
      run->host_physics(i, own_physics, "physics " + std::to_string(i));
      run->enqueue({0, i, twin::HostPhysics{true}});
    }
    const Made elsewhere = made(*run, 60);
    expect_same_bits(elsewhere.log, own.log, is_batch ? "in blocks" : "one by one");
    EXPECT_EQ(elsewhere.taken.size(), hosted.size() * 61);
    EXPECT_EQ(elsewhere.taken.back().source, "physics " + std::to_string(hosted.back()));
  }
}

TEST(HostedPhysics, TheRecordMakesTheRunAgainWithoutThem) {
  const twin::ReadyRun ready = mixed_fleet_ready();
  const auto run = begun(ready, helm_step_s);
  const std::vector<std::size_t> hosted = to_be_hosted(*run);
  // Not ours: each is pushed on by what nobody could foresee; and given back on the way.
  Rng rng(3, "hosted_physics_test");
  for (const std::size_t i : {hosted[0], hosted[3]}) {
    run->host_physics(
        i,
        [&](const HostedStep& step) -> std::optional<VehicleState<double>> {
          if (rng.bits() % 5 == 0) return std::nullopt;  // late: it stays as it is
          auto next = own_physics(step);
          next->body.position_m.x += 0.01 * rng.normal();
          return next;
        },
        "physics");
    run->enqueue({5, i, twin::HostPhysics{true}});
    run->enqueue({45, i, twin::HostPhysics{false}});
  }
  const Made first = made(*run, 60);
  for (const std::size_t threads : {1U, 2U})
    for (const bool is_batch : {true, false}) {
      const auto again = begun(ready, helm_step_s, threads, is_batch);
      for (const twin::Command& command : first.taken) again->enqueue(command);
      const Made second = made(*again, 60);
      expect_same_bits(second.log, first.log, std::to_string(threads));
      ASSERT_EQ(second.taken.size(), first.taken.size());
      for (std::size_t i = 0; i < first.taken.size(); ++i) {
        EXPECT_EQ(second.taken[i].step, first.taken[i].step) << i;
        EXPECT_EQ(second.taken[i].sequence, first.taken[i].sequence) << i;
      }
    }
}

TEST(HostedPhysics, AStateThatNoVehicleHasHaltsItAtTheEndOfTheStep) {
  const auto run = lone_run(lone("bluerov2_heavy", "north_m: 0, east_m: 0, depth_m: 20"));
  int asked = 0;
  run->host_physics(
      0,
      [&](const HostedStep& step) {
        auto next = own_physics(step);
        if (++asked == 10) next->body.nu.linear.x = NAN;
        return next;
      },
      "liar");
  run->enqueue({0, 0, twin::HostPhysics{true}});
  go_on(*run, 2);
  EXPECT_EQ(asked, 10);
  EXPECT_EQ(state_of_lone(*run).halt, twin::Halt::diverged);
  EXPECT_NEAR(state_of_lone(*run).halted_at_s, 0.5, 1e-9);
  EXPECT_TRUE(std::isfinite(state_of_lone(*run).vehicle.body.nu.linear.x));
}

TEST(HostedPhysics, OneThatIsHostedIsSeenAndMeetsWhatIsThere) {
  // Driven below the bed by its host it runs aground by our rules.
  const auto run = lone_run(lone("bluerov2_heavy", "north_m: 0, east_m: 0, depth_m: 50"));
  run->host_physics(
      0,
      [&](const HostedStep& step) {
        auto next = std::make_optional(step.state.vehicle);
        next->body.position_m.z += 0.1;
        return next;
      },
      "sinker");
  run->enqueue({0, 0, twin::HostPhysics{true}});
  go_on(*run, 2);
  EXPECT_NEAR(run->seen(0).position_m.z, 54, 0.01);
  go_on(*run, 20);
  EXPECT_EQ(state_of_lone(*run).halt, twin::Halt::aground);
}

TEST(HostedPhysics, WithoutAHostItStandsWhereItIs) {
  const auto run = lone_run(lone("bluerov2_heavy", "north_m: 0, east_m: 0, depth_m: 20", 0.4));
  run->enqueue({0, 0, twin::HostPhysics{true}});
  go_on(*run, 5);
  EXPECT_EQ(state_of_lone(*run).vehicle.body.position_m.y, 0);
  run->enqueue({0, 0, twin::HostPhysics{false}});
  steer(*run, {}, 20);
  EXPECT_GT(state_of_lone(*run).vehicle.body.position_m.y, 2);
}

}  // namespace
}  // namespace slackwater::tests::hosted_physics_test
