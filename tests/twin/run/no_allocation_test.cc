#include "tests/bench/counted_allocations.h"
#include "tests/twin/run/run_for_tests.h"

namespace slackwater::twin::no_allocation_test {
namespace {

TEST(NoAllocation, InAThousandStepsOfAFleetOnItsLegs) {
  // No waypoint and no task ends on the way: a mission that begins a route copies it.
  std::string yaml = tests::head(
      0.05,
      "{partitions: [{significant_height_m: 1, peak_period_s: 6, from_deg: 250}], components: 8}",
      "dryden");
  for (const std::string n : {"0", "1"}) {
    yaml += "  - {name: rov" + n + ", model: bluerov2_heavy, start: {north_m: " + n +
            "0, east_m: 0, depth_m: 10}, tether: {top: {north_m: 0, east_m: 0, depth_m: 1}, "
            "length_m: 60}, "
            "tasks: [{do: route, waypoints: [{north_m: " +
            n + "0, east_m: 300, depth_m: 12}]}]}\n";
    yaml += "  - {name: coarse" + n +
            ", model: bluerov2_heavy, detail: coarse, start: {north_m: " + n +
            "0, east_m: 0, depth_m: 10}, tether: {top: {north_m: 0, east_m: 0, depth_m: 1}, "
            "length_m: 60}, tasks: [{do: route, waypoints: [{north_m: " +
            n + "0, east_m: 300, depth_m: 12}]}]}\n";
    yaml += "  - {name: auv" + n + ", model: lrauv_tethys, start: {north_m: " + n +
            "0, east_m: 0, depth_m: 10}, tasks: [{do: route, waypoints: [{north_m: " + n +
            "0, east_m: 300, depth_m: 12}]}]}\n";
    yaml += "  - {name: usv" + n + ", model: wamv16, start: {north_m: " + n +
            "0, east_m: 0, depth_m: 0}, tasks: [{do: route, waypoints: [{north_m: " + n +
            "0, east_m: 300, depth_m: 0}]}]}\n";
  }
  yaml +=
      "  - {name: ctv, model: ctv24, start: {north_m: -90, east_m: 0, depth_m: 0}, tasks: [{do: "
      "route, waypoints: [{north_m: -90, east_m: 900, depth_m: 0}]}]}\n";
  yaml +=
      "  - {name: uav, model: x500, start: {north_m: 0, east_m: 0, height_m: 30}, tasks: [{do: "
      "route, "
      "waypoints: [{north_m: 500, east_m: 0, height_m: 35}]}]}\n";
  const ReadyRun ready = tests::ready_of(yaml);
  for (const bool is_batch : {true, false}) {
    for (const std::size_t threads : {1U, 2U}) {
      RunSettings settings = tests::settings_of(0.05);
      settings.is_batch = is_batch;
      settings.threads = threads;
      twin::Run run(ready.agents, ready.states, settings);
      RunLog log;
      log.reserve(ready.agents.size(), 60);
      for (int i = 0; i < 5; ++i) run.step();
      const std::size_t before = bench::allocations();
      for (int i = 0; i < 250; ++i) {
        run.step();
        if (i % 10 == 0) log.append(run.time_s(), run.agents(), run.states());
      }
      EXPECT_EQ(bench::allocations(), before) << is_batch << " on " << threads;
      EXPECT_EQ(run.states()[0].mission.waypoints_taken, 0U);
      EXPECT_FALSE(run.all_halted());
    }
  }
  // The counter counts: a log without room makes room.
  const std::size_t before = bench::allocations();
  RunLog log;
  log.append(0, ready.agents, ready.states);
  EXPECT_GT(bench::allocations(), before);
}

}  // namespace
}  // namespace slackwater::twin::no_allocation_test
