#include "fields/base/numbers/random.h"
#include "tests/twin/run/run_for_tests.h"

namespace slackwater::twin::corners_test {
namespace {

TEST(Corners, AnAuvRoundsARightAngleWithinItsTurningCircle) {
  // Water that pushes it out of the corner: 0.32 m/s there, for the 30 s of a quarter turn.
  // Turning circle: 1 m/s through the water at 3 degrees/s, 19 m.
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
  EXPECT_LT(farthest_east_m - 200, 19 + 1.3 * 0.32 * 30);
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

TEST(Corners, SurfaceCraftRoundASquareInSeaAndCurrentAndHoldItsEnd) {
  // Sides of which a vessel has the room to turn; the time is that of the way at cruise, and half
  // as much again.
  struct Craft {
    const char* model;
    double side_m, cruise_m_s, off_m;
  };
  for (const Craft& craft : {Craft{"wamv16", 120, 2.0, 4}, Craft{"ctv24", 900, 11.3, 30}}) {
    const std::string s = std::to_string(craft.side_m);
    const ReadyRun ready = tests::ready_of(
        tests::head(0.05,
                    "{partitions: [{significant_height_m: 0.5, peak_period_s: 5, from_deg: 250}], "
                    "components: 16}") +
        "  - {name: craft, model: " + craft.model +
        ", start: {north_m: 0, east_m: 0, depth_m: 0}, tasks: [{do: route, waypoints: [{north_m: " +
        s + ", east_m: 0, depth_m: 0}, {north_m: " + s + ", east_m: " + s +
        ", depth_m: 0}, {north_m: 0, east_m: " + s +
        ", depth_m: 0}, {north_m: 0, east_m: 0, depth_m: 0}]}, {do: hold, duration: 2min}]}\n");
    twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
    const double most_s = 6 * craft.side_m / craft.cruise_m_s + 400;
    double across_m = 0;
    while (run.time_s() < most_s && !run.states()[0].mission.is_done) {
      run.step();
      const AgentState& state = run.states()[0];
      const TrackError off = track_error(state.mission, state.vehicle.body.position_m);
      if (state.mission.task == 0) across_m = std::max(across_m, std::abs(off.across_m));
    }
    const AgentState& state = run.states()[0];
    EXPECT_TRUE(state.mission.is_done) << craft.model << ": task " << state.mission.task;
    EXPECT_EQ(state.halt, Halt::none) << craft.model;
    const Triple<double>& at = state.vehicle.body.position_m;
    EXPECT_LT(std::hypot(at.x, at.y), craft.off_m) << craft.model;
    // It turns once it is abeam of its waypoint and comes round to the next leg from outside. What
    // it turns with is less than the yaw rate that it is allowed asks for.
    EXPECT_LT(across_m, 1.7 * tightest_turn_m(*ready.agents[0].autopilot, craft.cruise_m_s))
        << craft.model;
    std::printf("%s: %.1f m across, held within %.2f m, done at %.0f s\n", craft.model, across_m,
                std::hypot(at.x, at.y), run.time_s());
    RecordProperty(std::string(craft.model) + "_across_m", std::to_string(across_m));
    RecordProperty(std::string(craft.model) + "_held_m", std::to_string(std::hypot(at.x, at.y)));
  }
}

TEST(Corners, ASlowRingOfShortChordsTakesAsLongAsItsSpeedSays) {
  // Chords of 1.3 m round a pile, as a cleaner goes. At 5 cm/s a chord that was taken up half a
  // metre before its beginning, from where the vehicle hurries to the corner, took 16 s of its 26.
  constexpr int chords = 24;
  constexpr double radius_m = 5, speed_m_s = 0.05;
  const auto at = [](int i) {
    const double angle = 2 * constants::pi * i / chords;
    return "{north_m: " + std::to_string(radius_m * std::cos(angle)) +
           ", east_m: " + std::to_string(radius_m * std::sin(angle)) + ", depth_m: 6}";
  };
  std::string waypoints;
  for (int i = 1; i <= chords; ++i) waypoints += (i > 1 ? ", " : "") + at(i);
  const ReadyRun ready = tests::ready_of(
      tests::calm_head(0.05) +
      "  - {name: cleaner, model: bluerov2_heavy, speed_m_s: " + std::to_string(speed_m_s) +
      ", start: " + at(0) + ", tasks: [{do: route, waypoints: [" + waypoints + "]}]}\n");
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
  const double way_m = chords * 2 * radius_m * std::sin(constants::pi / chords);
  while (run.time_s() < 2 * way_m / speed_m_s && !run.states()[0].mission.is_done) run.step();
  EXPECT_TRUE(run.states()[0].mission.is_done);
  RecordProperty("of_its_time", std::to_string(run.time_s() * speed_m_s / way_m));
  EXPECT_NEAR(run.time_s(), way_m / speed_m_s, 0.1 * way_m / speed_m_s);
}

TEST(Corners, AWaypointInsideTheTurnOfAVesselIsPassedNotCircled) {
  // The middle one lies where the middle of her turning circle at full moment is: she never comes
  // near it.
  const ReadyRun ready = tests::ready_of(
      tests::calm_head(0.05) +
      "  - {name: ctv, model: ctv24, start: {north_m: 0, east_m: 0, depth_m: 0}, tasks: [{do: "
      "route, waypoints: [{north_m: 1000, east_m: 0, depth_m: 0}, {north_m: 1000, east_m: 325, "
      "depth_m: 0}, {north_m: 1000, east_m: 2500, depth_m: 0}]}]}\n");
  const Agent& agent = ready.agents[0];
  const double turn_m = tightest_turn_m(*agent.autopilot, agent.mission.guidance.speed_m_s);
  EXPECT_GE(agent.mission.guidance.passing_m, turn_m);
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
  double steepest_rad_m = 0;
  while (run.time_s() < 600 && !run.states()[0].mission.is_done) {
    run.step();
    const Spatial<double>& nu = run.states()[0].vehicle.body.nu;
    if (nu.linear.x > 5)
      steepest_rad_m = std::max(steepest_rad_m, std::abs(nu.angular.z) / nu.linear.x);
  }
  EXPECT_EQ(run.states()[0].halt, Halt::none);
  EXPECT_TRUE(run.states()[0].mission.is_done) << run.states()[0].mission.waypoints_taken;
  // Her drift angle helps her round.
  std::printf("ctv24: turns within %.0f m, counted on %.0f m\n", 1 / steepest_rad_m, turn_m);
  EXPECT_LT(1 / steepest_rad_m, turn_m);
  EXPECT_GT(1 / steepest_rad_m, 0.5 * turn_m);
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
}  // namespace slackwater::twin::corners_test
