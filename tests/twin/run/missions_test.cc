#include "tests/twin/run/run_for_tests.h"

namespace slackwater::twin::missions_test {
namespace {

/// Steps until all tasks are done or the time is over. @return the time at which each task began
std::vector<double> run_tasks(twin::Run& run, double most_s, double step_s) {
  std::vector<double> began{0};
  while (run.time_s() < most_s && !run.all_halted()) {
    for (int i = 0; i < 5; ++i) run.step();
    const MissionState& mission = run.states()[0].mission;
    while (began.size() <= mission.task) began.push_back(run.time_s());
    if (mission.is_done) break;
  }
  (void)step_s;
  return began;
}

TEST(Missions, EveryKindOfTaskEndsAndTheNextBegins) {
  const ReadyRun ready =
      tests::ready_of(tests::head(0.05) +
                      "  - name: rov\n    model: bluerov2_heavy\n    speed_m_s: 0.6\n"
                      "    start: {north_m: 0, east_m: 0, depth_m: 10}\n    tasks:\n"
                      "      - {do: hold, duration: 1min}\n"
                      "      - {do: route, waypoints: [{north_m: 0, east_m: 4, depth_m: 11}, "
                      "{north_m: 4, east_m: 4, depth_m: 11}]}\n"
                      "      - {do: lawn_mower, corner: {north_m: 5, east_m: 5, depth_m: 11}, "
                      "course_deg: 0, length_m: 5, spacing_m: 2, lines: 2}\n"
                      "      - {do: orbit, centre: {north_m: 5, east_m: 10, depth_m: 11}, "
                      "radius_m: 2, turns: 1, end_depth_m: 12}\n"
                      "      - {do: depth_sweep, from: {north_m: 5, east_m: 12, depth_m: 12}, "
                      "course_deg: 90, length_m: 6, shallow_m: 11, deep_m: 13, wavelength_m: 6}\n"
                      "      - {do: hold, duration: 1min}\n");
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
  const std::vector<double> began = run_tasks(run, 600, 0.05);
  const AgentState& state = run.states()[0];
  ASSERT_TRUE(state.mission.is_done) << "in task " << state.mission.task;
  ASSERT_EQ(began.size(), 7U);
  // Seen at every fifth step.
  EXPECT_NEAR(began[1], 60, 0.35);
  EXPECT_NEAR(began[6] - began[5], 60, 0.35);
  // Length of the ways at 0.6 m/s at most, and not thrice as long.
  for (std::size_t i = 1; i < 5; ++i) {
    double way_m = 0;
    const std::vector<Waypoint>& w = ready.agents[0].mission.tasks[i].waypoints;
    for (std::size_t k = 1; k < w.size(); ++k) {
      const Triple<double> leg = w[k].position_m - w[k - 1].position_m;
      way_m += std::sqrt(dot(leg, leg));
    }
    EXPECT_GT(began[i + 1] - began[i], way_m / 0.6 - 3) << i;
    EXPECT_LT(began[i + 1] - began[i], 3 * way_m / 0.6 + 30) << i;
  }
  // It holds where the last route ended.
  const Triple<double> off =
      state.vehicle.body.position_m - ready.agents[0].mission.tasks[4].waypoints.back().position_m;
  EXPECT_LT(std::sqrt(dot(off, off)), 0.7);
}

TEST(Missions, ThePublicFollowerSteersAnRovRoundASquare) {
  // In still water: it knows of no current.
  for (const std::string follow : {"public"}) {
    const double side_m = follow == "paper" ? 100 : 15;
    const std::string s = std::to_string(side_m);
    const ReadyRun ready = tests::ready_of(
        tests::calm_head(0.05) + "  - name: rov\n    model: bluerov2_heavy\n    follow: " + follow +
        "\n    start: {north_m: 0, east_m: 0, depth_m: 10}\n    tasks:\n      - {do: route, "
        "waypoints: [{north_m: " +
        s + ", east_m: 0, depth_m: 10, speed_m_s: 1}, {north_m: " + s + ", east_m: " + s +
        ", depth_m: 10, speed_m_s: 1}, {north_m: 0, east_m: " + s +
        ", depth_m: 10, speed_m_s: 1}, {north_m: 0, east_m: 0, depth_m: 10, speed_m_s: 1}]}\n");
    twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
    (void)run_tasks(run, 1000, 0.05);
    EXPECT_EQ(run.states()[0].mission.waypoints_taken, 4U) << follow;
    EXPECT_TRUE(run.states()[0].mission.is_done) << follow;
    EXPECT_GT(run.time_s(), 4 * side_m / 1.1) << follow;
  }
}

/// An ROV that is to go north.
ReadyRun northbound(const std::string& tasks) {
  return tests::ready_of(
      tests::head(0.05) +
      "  - name: rov\n    model: bluerov2_heavy\n    start: {north_m: 0, east_m: 0, "
      "depth_m: 10}\n    tasks: [" +
      tasks + "]\n");
}
const std::string north = "{do: route, waypoints: [{north_m: 100, east_m: 0, depth_m: 10}]}";

double away_m(const AgentState& state, const Triple<double>& place_m) {
  const Triple<double> off = state.vehicle.body.position_m - place_m;
  return std::sqrt(dot(off, off));
}

TEST(Missions, WaypointsReplacedWhileItRunsAreFollowedFromWhereItIs) {
  const std::vector<Waypoint> other{{{5, 6, 12}, 0.5}, {{0, 8, 12}, 0.5}};
  // On a route, in a hold, and after all is done.
  for (const std::string& tasks :
       {north, std::string("{do: hold}"),
        std::string("{do: route, waypoints: [{north_m: 1, east_m: 0, depth_m: 10}]}")}) {
    const ReadyRun ready = northbound(tasks);
    twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
    for (int i = 0; i < 200; ++i) run.step();
    const Triple<double> here = run.states()[0].vehicle.body.position_m;
    run.enqueue({0, 0, Reroute{other}});
    run.step();
    EXPECT_NEAR(track_error(run.states()[0].helm.way, here).across_m, 0, 1e-9);
    for (int i = 1; i < 1200; ++i) run.step();
    EXPECT_LT(away_m(run.states()[0], other.back().position_m), 0.7) << tasks;
    EXPECT_EQ(run.states()[0].helm.way.waypoints_taken, 2U) << tasks;
  }
}

TEST(Missions, NoWaypointsInThePlaceOfARouteIsToStopHere) {
  const ReadyRun ready = northbound(north);
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
  for (int i = 0; i < 200; ++i) run.step();
  run.enqueue({0, 0, Reroute{}});
  const Triple<double> here = run.states()[0].vehicle.body.position_m;
  for (int i = 0; i < 600; ++i) run.step();
  EXPECT_LT(away_m(run.states()[0], here), 0.7);
}

TEST(Missions, ThoseOfOneThatWasReroutedStandStillUntilTheyAreResumed) {
  const ReadyRun ready = northbound(
      "{do: route, waypoints: [{north_m: 8, east_m: 0, depth_m: 10}]}, "
      "{do: route, waypoints: [{north_m: 3, east_m: 3, depth_m: 11}]}");
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
  for (int i = 0; i < 40; ++i) run.step();
  run.enqueue({0, 0, Reroute{{{{2, 0, 10}, 0.5}}}});
  for (int i = 0; i < 800; ++i) run.step();
  EXPECT_EQ(run.states()[0].mission.task, 0U);
  EXPECT_LT(away_m(run.states()[0], {2, 0, 10}), 0.7);
  run.enqueue({0, 0, Resume{}});
  for (int i = 0; i < 2000 && !run.states()[0].mission.is_done; ++i) run.step();
  for (int i = 0; i < 400; ++i) run.step();
  EXPECT_TRUE(run.states()[0].mission.is_done);
  EXPECT_LT(away_m(run.states()[0], {3, 3, 11}), 0.7);
}

}  // namespace
}  // namespace slackwater::twin::missions_test
