#include "fields/base/random.h"
#include "tests/twin/simulate/run_for_tests.h"

namespace slackwater::twin {
namespace {

TEST(Corners, AnAuvRoundsARightAngleWithinItsTurningCircle) {
  // Water that pushes it out of the corner. Turning circle: 1 m/s at 3 degrees/s, 19 m.
  const ReadyRun ready = tests::ready_of(tests::head(0.1) +
                                         "  - {name: auv, model: lrauv_tethys, start: {north_m: 0, "
                                         "east_m: 0, depth_m: 10, heading_deg: 90}, "
                                         "tasks: [{do: route, waypoints: [{north_m: 0, east_m: "
                                         "200, depth_m: 12}, {north_m: 200, east_m: 200, "
                                         "depth_m: 20}]}]}\n");
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.1));
  double farthest_east_m = 0, done_s = 0;
  for (int i = 0; i < 8000 && done_s == 0; ++i) {
    run.step();
    const AgentState& state = run.states()[0];
    farthest_east_m = std::max(farthest_east_m, state.vehicle.body.position_m.y);
    if (state.mission.is_done) done_s = run.time_s();
  }
  RecordProperty("overshoot_m", std::to_string(farthest_east_m - 200));
  EXPECT_LT(farthest_east_m - 200, 26);  // one circle and what the water adds in the time of a turn
  EXPECT_GT(done_s, 300);
  EXPECT_LT(done_s, 520);
}

TEST(Corners, AnAuvReachesTheEndOfAnyRouteInCurrentOfHalfItsSpeed) {
  Rng rng(11, "twin/corners_test");
  for (int trial = 0; trial < 6; ++trial) {
    const double speed = 0.5 * rng.uniform(), angle = rng.uniform(0, 2 * constants::pi);
    std::string yaml =
        "name: test\nseed: 7\nduration: 100min\nstep_s: 0.1\nwater: {made_up: {depth_m: 80, "
        "current: "
        "[{depth_m: 0, east_m_s: " +
        std::to_string(speed * std::cos(angle)) +
        ", north_m_s: " + std::to_string(speed * std::sin(angle)) +
        "}]}}\nvehicles:\n  - {name: auv, model: lrauv_tethys, start: {north_m: 0, east_m: 0, "
        "depth_m: 20, heading_deg: " +
        std::to_string(rng.uniform(0, 360)) + "}, tasks: [{do: route, waypoints: [";
    // Legs from shorter than a turn to long.
    double north = 0, east = 0, way_m = 0;
    for (int i = 0; i < 5; ++i) {
      const double leg = rng.uniform(10, 150), course = rng.uniform(0, 2 * constants::pi);
      north += leg * std::cos(course);
      east += leg * std::sin(course);
      way_m += leg;
      yaml += (i > 0 ? ", " : "") + ("{north_m: " + std::to_string(north) +
                                     ", east_m: " + std::to_string(east) + ", depth_m: 20}");
    }
    const ReadyRun ready = tests::ready_of(yaml + "]}]}\n");
    twin::Run run(ready.agents, ready.states, tests::settings_of(0.1));
    // Against the water it makes half its way; each corner may cost it two circles of 120 m.
    const double most_s = 2.5 * way_m + 5 * 240;
    while (run.time_s() < most_s && !run.states()[0].mission.is_done) run.step();
    EXPECT_TRUE(run.states()[0].mission.is_done)
        << "trial " << trial << ": waypoint " << run.states()[0].mission.waypoints_taken;
    EXPECT_EQ(run.states()[0].halt, Halt::none) << trial;
  }
}

TEST(Corners, AMultirotorOvershootsByLessThanItsBrakingDistance) {
  const ReadyRun ready =
      tests::ready_of(tests::head(0.02) +
                      "  - {name: uav, model: x500, speed_m_s: 5, start: {north_m: 0, east_m: 0, "
                      "height_m: 30}, tasks: [{do: route, "
                      "waypoints: [{north_m: 0, east_m: 60, height_m: 30}, {north_m: 60, east_m: "
                      "60, height_m: 30}]}]}\n");
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.02));
  double farthest_east_m = 0, fastest_m_s = 0;
  for (int i = 0; i < 2500 && !run.states()[0].mission.is_done; ++i) {
    run.step();
    farthest_east_m = std::max(farthest_east_m, run.seen(0).position_m.y);
    fastest_m_s = std::max(fastest_m_s, run.seen(0).velocity_m_s.y);
  }
  EXPECT_TRUE(run.states()[0].mission.is_done);
  EXPECT_GT(fastest_m_s, 4.5);
  // 5 m/s braked at 3 m/s2 take 4.2 m; half as much again for the tilting and the wind astern.
  EXPECT_LT(farthest_east_m - 60, 6.3);
}

}  // namespace
}  // namespace slackwater::twin
