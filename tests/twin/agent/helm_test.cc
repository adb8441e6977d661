#include "twin/agent/helm.h"

#include "tests/twin/run/helm_for_tests.h"

namespace slackwater::tests::helm_test {
namespace {

using twin::HelmCause;
using twin::HelmMode;
using twin::Triple;
using twin::Waypoint;

const std::string rov_start = "north_m: 0, east_m: 0, depth_m: 20";
std::unique_ptr<twin::Run> rov() { return lone_run(lone("bluerov2_heavy", rov_start)); }

double away_m(twin::Run& run, const Triple<double>& place_m) {
  return twin::length_of(state_of_lone(run).vehicle.body.position_m - place_m);
}

const std::vector<Waypoint> square{
    {{8, 0, 20}, 0.5}, {{8, 8, 20}, 0.5}, {{0, 8, 20}, 0.5}, {{0, 0, 20}, 0.5}};

TEST(Helm, FliesASquareAndHoldsAtItsEnd) {
  const auto run = rov();
  run->enqueue({0, 0, twin::Reroute{square}});
  double nearest_m[4] = {1e9, 1e9, 1e9, 1e9};
  int steps = 0;
  while (run->helm(0).mode != HelmMode::hold && steps < 4000) {
    run->step();
    ++steps;
    for (std::size_t i = 0; i < 4; ++i)
      nearest_m[i] = std::min(nearest_m[i], away_m(*run, square[i].position_m));
  }
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LT(nearest_m[i], 0.6) << i;
  // 32 m at 0.5 m/s, and it slows down at the corners.
  EXPECT_GT(run->time_s(), 60);
  EXPECT_LT(run->time_s(), 110);
  EXPECT_EQ(run->helm(0).cause, HelmCause::list_done);
  EXPECT_NEAR(run->helm(0).since_s, run->time_s() - helm_step_s, 1e-9);
  EXPECT_EQ(run->helm(0).way.waypoints_taken, 4U);
  go_on(*run, 600);  // nobody is missing at the helm: it does not go home
  EXPECT_EQ(run->helm(0).mode, HelmMode::hold);
  EXPECT_LT(away_m(*run, square.back().position_m), 0.5);
}

TEST(Helm, GoesRoundALoopUntilItIsToldOtherwise) {
  const auto run = rov();
  run->enqueue({0, 0, twin::Reroute{square, true}});
  while (run->helm(0).rounds < 2 && run->time_s() < 400) run->step();
  EXPECT_EQ(run->helm(0).rounds, 2U);
  EXPECT_EQ(run->helm(0).mode, HelmMode::waypoints);
  EXPECT_EQ(run->helm(0).way.waypoints_taken, 8U);
  EXPECT_LT(away_m(*run, square.back().position_m), 0.7);
  // It does not stop there.
  go_on(*run, 5);
  EXPECT_LT(away_m(*run, {1.5, 0, 20}), 1.5);
  run->enqueue({0, 0, twin::HoldHere{}});
  go_on(*run, 1);
  EXPECT_EQ(run->helm(0).mode, HelmMode::hold);
  EXPECT_EQ(run->helm(0).cause, HelmCause::asked);
}

TEST(Helm, ALoopOfOnePlaceIsAHold) {
  const auto run = rov();
  run->enqueue({0, 0, twin::Reroute{{{{1, 0, 20}, 0}}, true}});
  go_on(*run, 30);
  EXPECT_EQ(run->helm(0).mode, HelmMode::hold);
}

TEST(Helm, HoldsOneSecondAfterTheLastWordAndGoesHomeAMinuteLaterAtTheExactSteps) {
  for (const bool by_hand : {false, true}) {
    const auto run = rov();
    go_on(*run, 5);
    twin::Command command{0, 0, twin::SetVelocity{{0.5, 0, 0, 0}}};
    if (by_hand) command.what = twin::SetThrusters{std::vector<double>(8, 0.05)};
    const HelmMode mode = by_hand ? HelmMode::thrusters : HelmMode::velocity;
    run->enqueue(command);
    for (int i = 0; i < 10; ++i) run->step();
    run->enqueue(command);  // takes effect before step 110, at 5.5 s
    for (int i = 0; i < 20; ++i) {
      run->step();
      ASSERT_EQ(run->helm(0).mode, mode) << i;
    }
    EXPECT_EQ(run->steps_made(), 130U);
    run->step();
    EXPECT_EQ(run->helm(0).mode, HelmMode::hold);
    EXPECT_EQ(run->helm(0).cause, HelmCause::not_renewed);
    EXPECT_NEAR(run->helm(0).since_s, 6.5, 1e-9);
    for (int i = 0; i < 1199; ++i) {
      run->step();
      ASSERT_EQ(run->helm(0).mode, HelmMode::hold) << i;
    }
    run->step();
    EXPECT_EQ(run->helm(0).mode, HelmMode::home);
    EXPECT_EQ(run->helm(0).cause, HelmCause::held_too_long);
    go_on(*run, 60);
    EXPECT_LT(away_m(*run, {0, 0, 20}), 0.5) << "home is where it began";
    EXPECT_EQ(run->helm(0).mode, HelmMode::home);
  }
}

TEST(Helm, GoesHomeNeverWhereTheScenarioSaysSo) {
  const auto run = lone_run(lone("bluerov2_heavy", rov_start, 0, 0, "home_after_s: 0\n"));
  run->enqueue({0, 0, twin::SetVelocity{{0.5, 0, 0, 0}}});
  go_on(*run, 200);
  EXPECT_EQ(run->helm(0).mode, HelmMode::hold);
  const auto later = lone_run(lone("bluerov2_heavy", rov_start, 0, 0, "home_after: 2min\n"));
  later->enqueue({0, 0, twin::SetVelocity{{0.5, 0, 0, 0}}});
  go_on(*later, 119);
  EXPECT_EQ(later->helm(0).mode, HelmMode::hold);
  go_on(*later, 5);
  EXPECT_EQ(later->helm(0).mode, HelmMode::home);
}

TEST(Helm, WhoseClientIsLostHoldsWhereItIsAndThenGoesHome) {
  const auto run = rov();
  run->enqueue({0, 0, twin::Reroute{{{{100, 0, 20}, 0.5}}}});
  go_on(*run, 20);
  run->enqueue({0, 0, twin::HoldHere{true}});
  run->step();
  EXPECT_EQ(run->helm(0).cause, HelmCause::client_lost);
  const Triple<double> here = state_of_lone(*run).vehicle.body.position_m;
  go_on(*run, 55);
  EXPECT_LT(away_m(*run, here), 0.7);
  go_on(*run, 60);
  EXPECT_EQ(run->helm(0).mode, HelmMode::home);
  // One that is on its way home already, or at its own mission, needs nobody.
  const double since_s = run->helm(0).since_s;
  run->enqueue({0, 0, twin::HoldHere{true}});
  run->step();
  EXPECT_EQ(run->helm(0).mode, HelmMode::home);
  EXPECT_EQ(run->helm(0).since_s, since_s);
  run->enqueue({0, 0, twin::Resume{}});
  run->enqueue({0, 0, twin::HoldHere{true}});
  run->step();
  EXPECT_EQ(run->helm(0).mode, HelmMode::own);
}

TEST(Helm, GivenBackItsOwnRouteGoesOnWhereItWas) {
  std::string yaml = lone("bluerov2_heavy", rov_start);
  const std::string hold = "[{do: hold}]";
  yaml.replace(yaml.find(hold), hold.size(),
               "[{do: route, waypoints: [{north_m: 20, east_m: 0, depth_m: 20}, {north_m: 20, "
               "east_m: 10, depth_m: 20}]}]");
  const auto run = lone_run(yaml);
  go_on(*run, 10);
  const twin::MissionState before = state_of_lone(*run).mission;
  run->enqueue({0, 0, twin::Reroute{{{{0, -5, 22}, 0}}}});
  go_on(*run, 40);
  EXPECT_EQ(state_of_lone(*run).mission.route.next(), before.route.next());
  EXPECT_EQ(state_of_lone(*run).mission.held_s, before.held_s);
  run->enqueue({0, 0, twin::Resume{}});
  go_on(*run, 15);
  // Back on its leg north.
  EXPECT_LT(std::abs(twin::track_error(twin::way_of(state_of_lone(*run)),
                                       state_of_lone(*run).vehicle.body.position_m)
                         .across_m),
            0.7);
  go_on(*run, 120);
  EXPECT_TRUE(state_of_lone(*run).mission.is_done);
  EXPECT_LT(away_m(*run, {20, 10, 20}), 0.7);
}

TEST(Helm, GoesHomeRoundAStructure) {
  const std::string pile =
      "structures: [{name: pile, kind: cylinder, north_m: 10, east_m: 0, diameter_m: 6, "
      "top_height_m: 20, bottom_depth_m: 60}]\n";
  const auto run = lone_run(lone("bluerov2_heavy", rov_start, 0, 0, pile));
  run->enqueue({0, 0, twin::Reroute{{{{0, 8, 20}, 0}, {{20, 8, 20}, 0}, {{20, 0, 20}, 0}}}});
  go_on(*run, 150);
  ASSERT_LT(away_m(*run, {20, 0, 20}), 0.7);
  run->enqueue({0, 0, twin::GoHome{}});
  go_on(*run, 150);
  EXPECT_EQ(state_of_lone(*run).halt, twin::Halt::none);
  EXPECT_LT(away_m(*run, {0, 0, 20}), 0.7);
}

}  // namespace
}  // namespace slackwater::tests::helm_test
