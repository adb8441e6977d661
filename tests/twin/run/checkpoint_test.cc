#include "tests/twin/run/run_for_tests.h"

namespace slackwater::twin::checkpoint_test {
namespace {

TEST(Checkpoint, AnotherRunGoesOnFromItAsTheFirstWouldHave) {
  // Taken where AUVs hold, gusts blow, a tether swings and the ROVs' first waypoint lies some steps
  // ahead.
  const ReadyRun ready = tests::mixed_fleet_ready();
  constexpr int before = 15, after = 60;
  for (const bool is_batch : {false, true}) {
    RunSettings settings = tests::settings_of(0.05);
    settings.is_batch = is_batch;
    twin::Run whole(ready.agents, ready.states, settings);
    RunLog skipped, expected, got;
    tests::step_and_log(whole, before, skipped);
    tests::step_and_log(whole, after, expected);
    twin::Run first(ready.agents, ready.states, settings);
    tests::step_and_log(first, before, skipped);
    const twin::Run::Checkpoint checkpoint = first.checkpoint();
    // It is a value: what its run does later changes nothing.
    for (int i = 0; i < 7; ++i) first.step();
    twin::Run second(ready.agents, ready.states, settings);
    for (int i = 0; i < 3; ++i) second.step();
    second.restore(checkpoint);
    EXPECT_EQ(second.steps_made(), 15U);
    EXPECT_EQ(second.seen(0).position_m.x, checkpoint.states[0].vehicle.body.position_m.x);
    tests::step_and_log(second, after, got);
    tests::expect_same_bits(got, expected, is_batch ? "in blocks" : "one by one");
    // What the checkpoint has to carry did change.
    EXPECT_GE(expected.column(10, "task").back(), 1);
    EXPECT_EQ(skipped.column(10, "task").back(), 0);
    first.restore(checkpoint);
    RunLog again;
    tests::step_and_log(first, after, again);
    tests::expect_same_bits(again, expected, "the same run, back");
  }
}

TEST(Checkpoint, OfOtherVehiclesIsABug) {
  const ReadyRun ready = tests::mixed_fleet_ready();
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
  twin::Run::Checkpoint checkpoint = run.checkpoint();
  checkpoint.states.pop_back();
  EXPECT_ANY_THROW(run.restore(checkpoint));
}

}  // namespace
}  // namespace slackwater::twin::checkpoint_test
