// How a run can end for a vehicle: each ending has its sentence and its cause of risk, what was hit
// is told by what it is, one that is recovered is safe, and one that is not is told of.
#include <map>
#include <vector>

#include "fields/current/local_flow.h"
#include "tests/twin/run/run_for_tests.h"
#include "twin/account/vehicle_account.h"

namespace slackwater::tests::endings_test {
namespace {

using twin::AgentState;
using twin::Fate;
using twin::Halt;
using twin::RiskCause;

constexpr double ran_s = 600;

std::string pile(double top_depth_m) {
  return "name: test\nseed: 7\nduration: 5min\nstep_s: 0.05\nlog_every_s: 1\n"
         "water: {made_up: {depth_m: 35, current: [{depth_m: 0, east_m_s: 0.4, north_m_s: 0}]}}\n"
         "structures:\n  - {name: A01, kind: cylinder, north_m: 0, east_m: 23, diameter_m: 6, "
         "top_height_m: " +
         std::to_string(-top_depth_m) + ", bottom_depth_m: 35, turns_current: true}\nvehicles:\n";
}

twin::VehicleAccount account_after(twin::Run& run, double seconds) {
  twin::RunControl control(0);
  run.run_until(seconds, control);
  std::vector<twin::ScenarioStructure> named(1);
  named[0].name = "A01";
  return twin::account_of({run.agents(), run.states(), named, run.time_s()}, 0);
}

TEST(Endings, APileIsStruckByTheFirstOfItThatTouches) {
  // Bow down at the face, the centre of buoyancy is in the pile before the origin is.
  const auto run =
      begun(ready_of(pile(-20) + "  - {name: rov, model: bluerov2_heavy, start: {north_m: 0, "
                                 "east_m: 0, depth_m: 6}}\n"),
            0.05);
  twin::VehicleState<double> there = run->states()[0].vehicle;
  there.body.position_m = {0, 19.995, 6};
  there.body.attitude = twin::attitude_of({0, -1, constants::pi / 2});
  run->enqueue({0, 0, twin::PutVehicle{there}});
  const twin::VehicleAccount rov = account_after(*run, 5);
  EXPECT_EQ(rov.halt, Halt::struck);
  ASSERT_EQ(rov.fate.size(), 1U);
  EXPECT_EQ(rov.fate[0].what, Fate::struck_structure);
  EXPECT_EQ(rov.stopped_by, "struck a structure");
  EXPECT_EQ(rov.fate_text(run->agents()[0].water->environment().epoch)
                .rfind("struck a structure (A01) at ", 0),
            0U);
}

TEST(Endings, TheBedIsWhereItRanAground) {
  const auto run =
      begun(ready_of(pile(-20) + "  - {name: rov, model: bluerov2_heavy, start: {north_m: 0, "
                                 "east_m: 0, depth_m: 6}}\n"),
            0.05);
  twin::VehicleState<double> there = run->states()[0].vehicle;
  there.body.position_m.z = 36;
  run->enqueue({0, 0, twin::PutVehicle{there}});
  EXPECT_EQ(account_after(*run, 1).stopped_by, "ran aground");
}

TEST(Endings, OverASunkenPileThereIsOpenWater) {
  // The pile's top lies 10 m deep: over it the current of the forecast, beside it that which
  // goes round a pile.
  const twin::ReadyRun ready = ready_of(pile(10) +
                                        "  - {name: usv, model: wamv16, start: {north_m: 0, "
                                        "east_m: 0, depth_m: 0}}\n");
  const twin::EnvironmentSampler& water = *ready.agents[0].water;
  for (const double depth_m : {1.0, 9.0}) {
    const twin::WaterSample over = water.current({0, 23, depth_m}, 0, 0);
    ASSERT_TRUE(has_value(over.status)) << depth_m;
    EXPECT_NEAR(over.current_m_s.y, 0.4, 1e-7) << depth_m;
  }
  EXPECT_FALSE(has_value(water.current({0, 23, 11}, 0, 0).status));
  const auto beside = flow_around_pile({6, 1.05}, {0.4, 0}, {0, 5});
  ASSERT_TRUE(beside);
  EXPECT_NEAR(water.current({5, 23, 11}, 0, 0).current_m_s.y, beside->real(), 1e-7);
  const auto run = begun(ready, 0.05);
  twin::VehicleState<double> there = run->states()[0].vehicle;
  there.body.position_m = {0, 23, there.body.position_m.z};
  run->enqueue({0, 0, twin::PutVehicle{there}});
  EXPECT_EQ(account_after(*run, 5).halt, Halt::none);
}

/// Out by ten metres and home; from 48 % of its charge.
std::string there_and_home(const std::string& model, const std::string& how, double depth_m) {
  const std::string depth = ", depth_m: " + std::to_string(depth_m) + "}";
  return "name: test\nseed: 7\nduration: 60min\nstep_s: 0.05\nlog_every_s: 1\nwater: {made_up: "
         "{depth_m: 35}}\nvehicles:\n  - {name: it, model: " +
         model + ", state_of_charge: 0.48, start: {north_m: 0, east_m: 0" + depth +
         ", conduct: " + how + ", tasks: [{do: route, waypoints: [{north_m: 10, east_m: 0" + depth +
         ", {north_m: 0, east_m: 0" + depth + "]}]}\n";
}

TEST(Endings, NothingBefallsAVehicleThatIsBack) {
  for (const std::string model : {"bluerov2_heavy", "wamv16"}) {
    const auto run =
        begun(ready_of(there_and_home(model, "{reserve: {share: 0.1}}", model == "wamv16" ? 0 : 8)),
              0.05);
    const auto home = [&] { return run->states()[0]; };
    while (!run->has_ended(0) && run->time_s() < ran_s) run->step();
    const AgentState back = home();
    ASSERT_TRUE(back.conduct.has_ended) << model;
    EXPECT_TRUE(back.conduct.is_aboard) << model;
    // What drains batteries and turns craft over finds none in the water.
    for (int i = 0; i < 2000; ++i) run->step();
    const AgentState late = home();
    EXPECT_EQ(late.vehicle.drawn_j, back.vehicle.drawn_j) << model;
    EXPECT_EQ(late.vehicle.battery.charge, back.vehicle.battery.charge) << model;
    EXPECT_EQ(late.vehicle.body.position_m.x, back.vehicle.body.position_m.x) << model;
    EXPECT_EQ(late.halt, Halt::none) << model;
    const twin::VehicleAccount account =
        twin::account_of({run->agents(), run->states(), {}, run->time_s()}, 0);
    EXPECT_TRUE(account.fate.empty()) << model;
    EXPECT_TRUE(account.is_done) << model << account.stopped_by;
    EXPECT_TRUE(account.risks().none()) << model;
    EXPECT_EQ(account.mission.back().text, "aboard") << model;
  }
}

TEST(Endings, WhoTakesTheHelmPutsItOutAgain) {
  const auto run = begun(ready_of(there_and_home("bluerov2_heavy", "{}", 8)), 0.05);
  while (!run->has_ended(0) && run->time_s() < ran_s) run->step();
  ASSERT_TRUE(run->states()[0].conduct.is_aboard);
  const double before_j = run->states()[0].vehicle.drawn_j;
  for (int i = 0; i < 200; ++i) {
    if (i % 10 == 0) run->enqueue({0, 0, twin::SetVelocity{{0.3, 0, 0, 0}}});
    run->step();
  }
  const AgentState out = run->states()[0];
  EXPECT_FALSE(out.conduct.is_aboard);
  EXPECT_GT(out.vehicle.body.nu.linear.x, 0.2);
  EXPECT_GT(out.vehicle.drawn_j, before_j + 100);
  EXPECT_EQ(out.conduct.events.back().kind, twin::ConductEventKind::launched);
}

TEST(Endings, ARecoveredVehicleWithLessThanItsReserveStillBrokeIt) {
  const auto run =
      begun(ready_of(there_and_home("bluerov2_heavy", "{reserve: {share: 0.47999}}", 8)), 0.05);
  while (!run->has_ended(0) && run->time_s() < ran_s) run->step();
  ASSERT_TRUE(run->states()[0].conduct.is_aboard);
  const twin::VehicleAccount account =
      twin::account_of({run->agents(), run->states(), {}, run->time_s()}, 0);
  EXPECT_TRUE(account.broke_reserve);
  EXPECT_TRUE(account.risks().has(RiskCause::energy));
}

TEST(Endings, WithoutItsThrustersAVehicleIsNotRecovered) {
  const auto run = begun(
      ready_of(there_and_home("bluerov2_heavy",
                              "{faults: [{fault: lost_thruster, at_s: 5, thruster: 0}, {fault: "
                              "lost_thruster, at_s: 5, thruster: 1}, {fault: lost_thruster, at_s: "
                              "5, thruster: 2}, {fault: lost_thruster, at_s: 5, thruster: 3}]}",
                              8)),
      0.05);
  const twin::VehicleAccount rov = account_after(*run, 300);
  EXPECT_EQ(rov.halt, Halt::none);
  EXPECT_EQ(rov.stopped_by, "not recovered: lost thruster");
  ASSERT_FALSE(rov.fate.empty());
  EXPECT_EQ(rov.fate.back().what, Fate::not_recovered);
  EXPECT_EQ(rov.fate.back().at_s, 300.0);
  twin::RiskCauses only;
  only.add(RiskCause::recovery);
  EXPECT_EQ(rov.risks(), only);
  EXPECT_FALSE(rov.is_done);
}

/// What an account says of a vehicle that is out at its work, changed.
template <typename Change>
twin::VehicleAccount outcome_with(Change&& change) {
  twin::ReadyRun ready = ready_of(there_and_home("bluerov2_heavy", "{}", 8));
  change(ready.states[0]);
  return twin::account_of({ready.agents, ready.states, {}, ran_s}, 0);
}

TEST(Endings, EachHasItsSentenceAndItsCauseByOneOrder) {
  struct Ending {
    std::function<void(AgentState&)> change;
    std::string stopped_by;
    std::vector<Fate> fate;
    std::vector<RiskCause> causes;
  };
  const auto halted = [](Halt why) { return [why](AgentState& s) { twin::halt(s, why, 100); }; };
  const auto ended = [](AgentState& s) {
    s.conduct.has_ended = true;
    s.mission.is_done = true;
    s.conduct.events.push_back({90, twin::ConductEventKind::finished});
  };
  const std::vector<Ending> endings{
      {halted(Halt::struck),
       "struck a structure",
       {Fate::struck_structure},
       {RiskCause::collision}},
      {halted(Halt::aground), "ran aground", {Fate::aground}, {RiskCause::collision}},
      {halted(Halt::capsized), "capsized", {Fate::capsized}, {RiskCause::station}},
      {halted(Halt::no_headway),
       "made no headway against the water",
       {Fate::slower_than_water},
       {RiskCause::station}},
      {halted(Halt::outside_area),
       "left the area of the forecast",
       {Fate::left_area},
       {RiskCause::recovery}},
      {halted(Halt::outside_time),
       "came to the end of the forecast",
       {Fate::forecast_ended},
       {RiskCause::recovery}},
      {halted(Halt::no_data),
       "came where the forecast has no data",
       {Fate::no_data},
       {RiskCause::recovery}},
      {halted(Halt::diverged), "its calculation diverged", {Fate::diverged}, {RiskCause::work}},
      // The cause of a collision comes before it.
      {[&](AgentState& s) {
         s.milestones.power_lost_s = 80;
         twin::halt(s, Halt::struck, 100);
       },
       "battery cut off at its least voltage",
       {Fate::battery_cut_off, Fate::struck_structure},
       {RiskCause::energy, RiskCause::collision}},
      // Adrift.
      {[](AgentState& s) { s.milestones.power_lost_s = 80; },
       "not recovered: battery cut off at its least voltage",
       {Fate::battery_cut_off, Fate::not_recovered},
       {RiskCause::energy, RiskCause::recovery}},
      {[](AgentState& s) { s.milestones.line_parted_s = 80; },
       "not recovered: its tether parted",
       {Fate::tether_parted, Fate::not_recovered},
       {RiskCause::tether, RiskCause::recovery}},
      {[](AgentState& s) {
         s.conduct.has_turned = true;
         s.conduct.cause = twin::Cause::thruster;
       },
       "not recovered: lost thruster",
       {Fate::not_recovered},
       {RiskCause::recovery}},
      {[](AgentState&) {},
       "not recovered: out of time",
       {Fate::not_recovered},
       {RiskCause::recovery}},
      // Back: what comes then is no part of it.
      {ended, "", {}, {}},
      {[&](AgentState& s) {
         ended(s);
         s.conduct.has_turned = true;
         s.conduct.cause = twin::Cause::thruster;
       },
       "lost thruster",
       {},
       {RiskCause::work}},
      {[](AgentState& s) { s.conduct.is_aboard = true; }, "out of time", {}, {RiskCause::work}}};
  for (const Ending& ending : endings) {
    const twin::VehicleAccount account = outcome_with(ending.change);
    EXPECT_EQ(account.stopped_by, ending.stopped_by);
    std::vector<Fate> fate;
    for (const twin::FateEvent& event : account.fate) fate.push_back(event.what);
    EXPECT_EQ(fate, ending.fate) << ending.stopped_by;
    twin::RiskCauses causes;
    for (const RiskCause cause : ending.causes) causes.add(cause);
    EXPECT_EQ(account.risks(), causes) << ending.stopped_by;
    EXPECT_EQ(account.is_done, ending.stopped_by.empty());
  }
}

TEST(Endings, TheWordsOfAllAreDifferentAndReadBack) {
  std::map<std::string, int> seen;
  for (int i = 0; i <= static_cast<int>(Fate::not_recovered); ++i) {
    const auto fate = static_cast<Fate>(i);
    EXPECT_EQ(twin::fate_named(twin::name_of(fate)), fate);
    EXPECT_EQ(++seen[twin::words_of(fate)], 1) << twin::words_of(fate);
  }
}

}  // namespace
}  // namespace slackwater::tests::endings_test
