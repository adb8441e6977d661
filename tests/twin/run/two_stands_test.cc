#include "tests/twin/run/run_for_tests.h"
#include "twin/agent/company.h"
#include "twin/agent/conduct.h"
#include "twin/agent/hung_line.h"
#include "twin/agent/line_on_deck.h"

namespace slackwater::tests::two_stands_test {
namespace {

using twin::ConductEvent;
using Kind = twin::ConductEventKind;
using twin::length_of;
using twin::Triple;

/// A WAM-V that stands by at two places some 90 m of way apart, and an ROV on a line from her deck
/// that looks at something at each of them.
std::string two_stands(const std::string& rov_conduct = "{}",
                       const std::string& tender_conduct = "{}",
                       const std::string& detail = "full") {
  return head(0.05,
              "{partitions: [{significant_height_m: 0.3, peak_period_s: 4, from_deg: 270}], "
              "components: 8}") +
         "  - name: tender\n    model: wamv16\n    start: {north_m: -24, east_m: 0, depth_m: 0}\n"
         "    speed_m_s: 1.5\n    conduct: " +
         tender_conduct +
         "\n    tasks:\n      - {do: stand_by}\n      - {do: route, waypoints: [{north_m: -24, "
         "east_m: 25, depth_m: 0}, {north_m: 40, east_m: 30, depth_m: 0}]}\n      - {do: "
         "stand_by}\n"
         "  - name: rov\n    model: bluerov2_heavy\n    start: {north_m: -24, east_m: 0, depth_m: "
         "3}\n    speed_m_s: 0.5\n    detail: " +
         detail +
         "\n    tether: {length_m: 40}\n    carrier: {name: tender, forward_m: 1, up_m: 1}\n    "
         "conduct: " +
         rov_conduct +
         "\n    tasks:\n"
         "      - {do: aboard, phase: transit, until: stand_by}\n"
         "      - {do: aboard, phase: launch, duration_s: 10}\n"
         "      - {do: route, phase: work, waypoints: [{north_m: -14, east_m: 4, depth_m: 9}, "
         "{north_m: -22, east_m: 0, depth_m: 4}]}\n"
         "      - {do: aboard, phase: recovery, duration_s: 15}\n"
         "      - {do: aboard, phase: transit, until: stand_by, duration_s: 20, battery: swap}\n"
         "      - {do: aboard, phase: launch, duration_s: 10}\n"
         "      - {do: route, phase: work, waypoints: [{north_m: 50, east_m: 22, depth_m: 9}, "
         "{north_m: 42, east_m: 28, depth_m: 4}]}\n"
         "      - {do: aboard, phase: recovery, duration_s: 15}\n"
         "structures:\n  - {name: first, kind: cylinder, north_m: 0, east_m: 0, diameter_m: 6, "
         "top_height_m: 20, bottom_depth_m: 60}\n  - {name: second, kind: cylinder, north_m: 62, "
         "east_m: 10, diameter_m: 6, top_height_m: 20, bottom_depth_m: 60}\n";
}

std::unique_ptr<twin::Run> run_of(const std::string& yaml, std::size_t threads = 1,
                                  bool is_batch = true) {
  return begun(ready_of(yaml), 0.05, threads, is_batch);
}

std::vector<ConductEvent> events(twin::Run& run, std::size_t vehicle, Kind kind) {
  std::vector<ConductEvent> out;
  for (const ConductEvent& event : run.states()[vehicle].conduct.events)
    if (event.kind == kind) out.push_back(event);
  return out;
}

bool is_out(twin::Run& run) { return twin::has_line_out(run.agents()[1], run.states()[1]); }

/// Steps to the end, or `most_s`.
/// @return how far the carrier came from where the line was laid, while it was in the water
double fly(twin::Run& run, double most_s = 1200) {
  bool was_out = is_out(run);
  double most_m = 0;
  Triple<double> laid_m = run.seen(0).position_m;
  while (run.time_s() < most_s && !run.all_ended()) {
    run.step();
    if (is_out(run) && !was_out) laid_m = run.seen(0).position_m;
    was_out = is_out(run);
    if (was_out) most_m = std::max(most_m, length_of(run.seen(0).position_m - laid_m));
  }
  return most_m;
}

TEST(TwoStands, AnRovIsLaunchedAtEachOfThemAndTheCarrierStaysMeanwhile) {
  for (const char* detail : {"full", "coarse"}) {
    SCOPED_TRACE(detail);
    const auto run = run_of(two_stands("{}", "{}", detail));
    EXPECT_LT(fly(*run), 8);
    EXPECT_TRUE(run->all_ended());
    const auto launched = events(*run, 1, Kind::launched);
    const auto aboard = events(*run, 1, Kind::came_aboard);
    ASSERT_EQ(launched.size(), 2U);
    ASSERT_EQ(aboard.size(), 2U);
    EXPECT_NEAR(launched[0].t_s, 11, 2);
    // Recovered for 15 s, then some 90 m at 1.5 m/s, then launched for 10 s.
    EXPECT_GT(launched[1].t_s - aboard[0].t_s, 15 + 90 / 1.5 + 10 - 10);
    EXPECT_LT(launched[1].t_s - aboard[0].t_s, 15 + 90 / 1.5 + 10 + 60);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(events(*run, i, Kind::finished).size(), 1U) << i;
    EXPECT_NEAR(run->seen(0).position_m.x, 40, 8);
    const twin::AgentState& rov = run->states()[1];
    EXPECT_TRUE(rov.conduct.is_aboard);
    EXPECT_EQ(rov.tether.whole, 1);
    EXPECT_EQ(rov.tether_n, 0);
    EXPECT_EQ(run->states()[0].borne.force_n.x, 0);
    // Its line may wind about the second pile now, not about the first.
    EXPECT_EQ(rov.conduct.worked_at, 1U);
  }
}

TEST(TwoStands, TheLineIsAboardWithTheVehicleAndLaidAnewFromWhereTheDeckIs) {
  const auto run = run_of(two_stands());
  bool was_out = false;
  int laid = 0;
  while (run->time_s() < 1200 && !run->all_ended()) {
    run->step();
    const twin::AgentState& rov = run->states()[1];
    const auto nodes = twin::hung_line(run->agents()[1], rov);
    if (is_out(*run)) {
      EXPECT_LT(length_of(nodes.front() - twin::deck_place(run->agents()[1], run->states()[0])),
                1e-12);
      double length_m = 0;
      for (std::size_t i = 1; i < nodes.size(); ++i) length_m += length_of(nodes[i] - nodes[i - 1]);
      EXPECT_NEAR(length_m, 40, 1.5);
    } else {
      for (const double tension_n : rov.tether.tension_n) EXPECT_EQ(tension_n, 0);
    }
    if (is_out(*run) && !was_out) ++laid;
    was_out = is_out(*run);
  }
  EXPECT_EQ(laid, 2);
}

TEST(TwoStands, IsTheSameToTheBitHoweverItIsSteppedAndTakenUpInTheSecondLaunch) {
  for (const char* detail : {"full", "coarse"}) {
    SCOPED_TRACE(detail);
    const std::string yaml = two_stands("{}", "{}", detail);
    const auto whole = run_of(yaml);
    fly(*whole);
    const double launched_s = events(*whole, 1, Kind::launched).at(1).t_s;
    const int steps = static_cast<int>(std::lround((launched_s + 30) / 0.05));
    twin::RunLog expected, threads, one_by_one;
    const auto a = run_of(yaml), b = run_of(yaml, 2), c = run_of(yaml, 1, false);
    step_and_log(*a, steps, expected);
    step_and_log(*b, steps, threads);
    step_and_log(*c, steps, one_by_one);
    expect_same_bits(threads, expected, "two threads");
    expect_same_bits(one_by_one, expected, "one by one");
    // On deck before it, in the step of it, and with the line some pulls old.
    for (const double from_s : {-4.0, 0.05, 0.35}) {
      const int before = static_cast<int>(std::lround((launched_s + from_s) / 0.05));
      twin::RunLog taken_up;
      const auto d = run_of(yaml), e = run_of(yaml);
      step_and_log(*d, before, taken_up);
      EXPECT_EQ(is_out(*d), from_s > 0);
      e->restore(d->checkpoint());
      step_and_log(*e, steps - before, taken_up);
      expect_same_bits(taken_up, expected, "taken up " + std::to_string(from_s));
    }
  }
}

TEST(TwoStands, NeitherIsKeptFromTheOtherNorFromTheLineBetweenThem) {
  const auto run =
      run_of(two_stands() + "clearance: {craft_m: 8, structure_m: 1, tether_m: 3, vessel_m: 50}\n");
  EXPECT_LT(fly(*run), 8);
  EXPECT_TRUE(run->all_ended());
  for (const twin::AgentState& state : run->states()) {
    EXPECT_EQ(state.clearance.alarms, 0);
    EXPECT_EQ(state.clearance.changed_s, 0);
    EXPECT_TRUE(std::isinf(state.nearest.line.distance_m));
  }
}

/// Its receiver lost, the carrier is to come home at once.
std::string turns_at(double at_s) {
  return "{faults: [{fault: lost_gnss, at_s: " + std::to_string(at_s) +
         "}], home: {north_m: -80, east_m: 0, depth_m: 0}, behaviour: {fallback: [{guard: {while: "
         "gnss_up, then: {do: carry_on}}}, {do: come_home}]}}";
}

TEST(TwoStands, ACarrierThatTurnsForHomeTakesItsVehicleAboardFirst) {
  const auto run = run_of(two_stands("{}", turns_at(25)));
  EXPECT_LT(fly(*run), 8);
  const auto turned = events(*run, 0, Kind::turned_for_home),
             home = events(*run, 0, Kind::came_home);
  ASSERT_EQ(turned.size(), 1U);
  ASSERT_EQ(home.size(), 1U);
  const auto called = events(*run, 1, Kind::turned_for_home);
  ASSERT_EQ(called.size(), 1U);
  EXPECT_EQ(called[0].cause, twin::Cause::carrier);
  EXPECT_NEAR(called[0].t_s, turned[0].t_s, 2.01);
  const auto aboard = events(*run, 1, Kind::came_aboard);
  ASSERT_EQ(aboard.size(), 1U);
  EXPECT_GT(aboard[0].t_s, called[0].t_s);
  EXPECT_GT(home[0].t_s, aboard[0].t_s);
  EXPECT_NEAR(run->seen(0).position_m.x, -80, 8);
  EXPECT_LT(length_of(run->seen(0).position_m - run->seen(1).position_m), 6);
}

TEST(TwoStands, ACarrierThatTurnsAsItsVehicleIsLaunchedWaitsForThatToo) {
  // At each tick about that of the launch, and from a vehicle that does not heed her.
  for (const double at_s : {10.0, 11.0, 12.0, 13.0, 14.0}) {
    SCOPED_TRACE(at_s);
    const auto run = run_of(two_stands("{behaviour: {do: carry_on}}", turns_at(at_s)));
    EXPECT_LT(fly(*run, 300), 8);
    const auto launched = events(*run, 1, Kind::launched),
               aboard = events(*run, 1, Kind::came_aboard);
    ASSERT_EQ(launched.size(), 1U);
    ASSERT_EQ(aboard.size(), 1U);
    EXPECT_GT(aboard[0].t_s, launched[0].t_s + 20);
    ASSERT_EQ(events(*run, 0, Kind::came_home).size(), 1U);
    EXPECT_GT(events(*run, 0, Kind::came_home)[0].t_s, aboard[0].t_s);
  }
}

TEST(TwoStands, AFouledLineHoldsVehicleAndCarrierUntilItIsFree) {
  const auto run = run_of(two_stands("{faults: [{fault: fouled_tether, at_s: 25, for_s: 90}]}"));
  while (run->time_s() < 110) run->step();
  EXPECT_TRUE(run->states()[1].conduct.is_snagged);
  EXPECT_EQ(run->states()[1].conduct.doing, twin::Doing::hold);
  EXPECT_EQ(run->states()[0].mission.task, 0U);
  EXPECT_LT(fly(*run), 8);
  EXPECT_EQ(events(*run, 1, Kind::finished).size(), 1U);
  EXPECT_EQ(events(*run, 1, Kind::launched).size(), 2U);
}

TEST(TwoStands, AVehicleWhoseLineStaysFouledIsNotTakenAboardAndTheCarrierStays) {
  const auto run = run_of(
      two_stands("{faults: [{fault: fouled_tether, at_s: 25}], behaviour: {fallback: [{guard: "
                 "{while: tether_free, then: {do: carry_on}}}, {do: come_home}]}}"));
  EXPECT_LT(fly(*run, 300), 8);
  EXPECT_FALSE(run->all_ended());
  EXPECT_TRUE(is_out(*run));
  EXPECT_EQ(run->states()[0].mission.task, 0U);
  EXPECT_TRUE(events(*run, 1, Kind::came_aboard).empty());
  EXPECT_EQ(events(*run, 1, Kind::turned_for_home).at(0).cause, twin::Cause::tether);
}

TEST(TwoStands, ALineThatPartedHoldsNobody) {
  const auto run = run_of(two_stands("{}", turns_at(25)));
  while (run->time_s() < 24) run->step();
  twin::Run::Checkpoint parted = run->checkpoint();
  parted.states[1].tether.whole = 0;
  run->restore(parted);
  run->step();
  EXPECT_FALSE(is_out(*run));
  while (run->time_s() < 40) run->step();
  EXPECT_FALSE(run->states()[0].conduct.waits_for_line);
  EXPECT_EQ(run->states()[0].conduct.doing, twin::Doing::way_home);
  EXPECT_TRUE(run->states()[0].conduct.way.is_rerouted);
}

}  // namespace
}  // namespace slackwater::tests::two_stands_test
