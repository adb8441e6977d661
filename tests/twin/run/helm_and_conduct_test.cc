#include "tests/twin/run/helm_for_tests.h"

namespace slackwater::tests::helm_and_conduct_test {
namespace {

using twin::ConductEventKind;
using twin::Doing;
using twin::HelmCause;
using twin::HelmMode;

/// An ROV that goes 200 m north and has a tree.
std::string conducted(const std::string& conduct, const std::string& more = "") {
  return calm_head(helm_step_s) +
         "  - name: rov\n    model: bluerov2_heavy\n    start: {north_m: 0, east_m: 0, depth_m: "
         "10}\n    speed_m_s: 0.5\n" +
         more + "    conduct: " + conduct +
         "\n    tasks: [{do: route, phase: work, waypoints: [{north_m: 200, east_m: 0, depth_m: "
         "10}]}]\n";
}

std::size_t events(twin::Run& run, ConductEventKind kind) {
  std::size_t count = 0;
  for (const twin::ConductEvent& event : run.states()[0].conduct.events)
    count += event.kind == kind ? 1 : 0;
  return count;
}

TEST(HelmAndConduct, TheTreeStandsStillAndGoesOnWhenItIsResumed) {
  const auto run = lone_run(conducted("{}"));
  go_on(*run, 20);
  const std::size_t before = run->conduct(0).events.size();
  steer(*run, {0, 0.3, 0, 0}, 40);
  EXPECT_EQ(run->conduct(0).doing, Doing::task);
  EXPECT_EQ(run->conduct(0).events.size(), before);
  EXPECT_FALSE(run->has_ended(0));
  const double waited_m = state_of_lone(*run).vehicle.body.position_m.x;
  run->enqueue({0, 0, twin::Resume{}});
  go_on(*run, 60);
  const auto& at = state_of_lone(*run).vehicle.body.position_m;
  EXPECT_GT(at.x, waited_m + 10);
  EXPECT_NEAR(at.y, 0, 0.5);
}

TEST(HelmAndConduct, ALimitDoesNotTakeTheHelmAway) {
  // Without a link the tree would hold; who is at the helm is there all the same.
  const auto run =
      lone_run(conducted("{autonomy: shared, faults: [{fault: lost_link, at_s: 30}]}"));
  steer(*run, {0.5, 0, 0, 0}, 60);
  EXPECT_EQ(run->helm(0).mode, HelmMode::velocity);
  EXPECT_EQ(events(*run, ConductEventKind::fault_began), 1U);
  EXPECT_EQ(events(*run, ConductEventKind::hold_began), 0U);
}

TEST(HelmAndConduct, TheReserveTakesItBackAndBringsItHome) {
  // A battery that has little more than its reserve, driven away from home.
  const auto run =
      lone_run(conducted("{reserve: {share: 0.2, margin: 1.3}}", "    state_of_charge: 0.23\n"));
  double taken_back_s = 0;
  for (int i = 0; i < 36000 && taken_back_s == 0; ++i) {
    if (i % 10 == 0) run->enqueue({0, 0, twin::SetVelocity{{0.7, 0, 0, 0}}});
    run->step();
    if (i > 0 && !run->helm(0).is_helmed()) taken_back_s = run->time_s();
  }
  ASSERT_GT(taken_back_s, 1);
  EXPECT_EQ(run->helm(0).cause, HelmCause::reserve);
  EXPECT_EQ(run->conduct(0).doing, Doing::way_home);
  EXPECT_EQ(events(*run, ConductEventKind::turned_for_home), 1U);
  EXPECT_TRUE(run->must_come_home(0));
  // Whoever goes on asking is not heard: it comes home.
  for (int i = 0; i < 200; ++i) {
    run->enqueue({0, 0, twin::SetVelocity{{0.7, 0, 0, 0}}});
    run->enqueue({0, 0, twin::HoldHere{}});
    run->step();
    ASSERT_EQ(run->helm(0).mode, HelmMode::own);
  }
  while (!run->has_ended(0) && run->time_s() < 3000) run->step();
  EXPECT_EQ(events(*run, ConductEventKind::came_home), 1U);
  EXPECT_LT(
      twin::length_of(state_of_lone(*run).vehicle.body.position_m - twin::Triple<double>{0, 0, 10}),
      1);
}

TEST(HelmAndConduct, WhoseTreeHasEndedIsBroughtHomeByItsReserveToo) {
  // Its tasks are over at once; then it is driven until its energy is needed.
  std::string yaml =
      conducted("{reserve: {share: 0.2, margin: 1.3}}", "    state_of_charge: 0.23\n");
  yaml.replace(yaml.find("north_m: 200"), 12, "north_m: 0.1");
  const auto run = lone_run(yaml);
  go_on(*run, 5);
  ASSERT_TRUE(run->has_ended(0));
  for (int i = 0; i < 36000 && run->helm(0).mode != HelmMode::home; ++i) {
    if (i % 10 == 0) run->enqueue({0, 0, twin::SetVelocity{{0.7, 0, 0, 0}}});
    run->step();
  }
  EXPECT_EQ(run->helm(0).cause, HelmCause::reserve);
  EXPECT_GT(state_of_lone(*run).vehicle.body.position_m.x, 5);
  go_on(*run, 400);
  EXPECT_LT(
      twin::length_of(state_of_lone(*run).vehicle.body.position_m - twin::Triple<double>{0, 0, 10}),
      1);
}

TEST(HelmAndConduct, ATreeThatDoesNotAskForItsReserveHasNoneUnderTheHelmEither) {
  const auto run =
      lone_run(conducted("{behaviour: {do: carry_on}}", "    state_of_charge: 0.202\n"));
  steer(*run, {0.7, 0, 0, 0}, 300);
  EXPECT_FALSE(run->must_come_home(0));
  EXPECT_EQ(run->helm(0).mode, HelmMode::velocity);
}

TEST(HelmAndConduct, HomeIsByTheWayThatItsConductHas) {
  const auto run = lone_run(conducted("{home: {north_m: 5, east_m: 12, depth_m: 10}}"));
  go_on(*run, 20);
  run->enqueue({0, 0, twin::GoHome{}});
  go_on(*run, 90);
  EXPECT_LT(twin::length_of(state_of_lone(*run).vehicle.body.position_m -
                            twin::Triple<double>{5, 12, 10}),
            0.7);
}

TEST(HelmAndConduct, OneThatStandsAboardTakesNoCommand) {
  std::string yaml = conducted("{}");
  const std::string tasks = "tasks: [";
  yaml.insert(yaml.find(tasks) + tasks.size(), "{do: aboard, duration: 1min}, ");
  const auto run = lone_run(yaml);
  run->enqueue({0, 0, twin::SetVelocity{{0.5, 0, 0, 0}}});
  go_on(*run, 2);
  ASSERT_TRUE(run->conduct(0).is_aboard);
  EXPECT_EQ(run->helm(0).mode, HelmMode::own);
  EXPECT_EQ(run->commands_taken().size(), 1U);
}

}  // namespace
}  // namespace slackwater::tests::helm_and_conduct_test
