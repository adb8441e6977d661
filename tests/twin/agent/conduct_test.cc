#include "twin/agent/conduct.h"

#include "fields/base/error.h"
#include "tests/twin/run/run_for_tests.h"
#include "twin/mission/way_round.h"

namespace slackwater::tests::conduct_test {
namespace {

using twin::Cause;
using twin::ConductEvent;
using twin::ConductEventKind;
using Kind = ConductEventKind;

/// An ROV in still water that goes 30 m north at 0.5 m/s and then home.
std::string rov_on_a_line(const std::string& conduct, const std::string& more = "") {
  return "  - name: rov\n    model: bluerov2_heavy\n"
         "    start: {north_m: 0, east_m: 0, depth_m: 10}\n    speed_m_s: 0.5\n" +
         more + "    conduct: " + conduct +
         "\n    tasks:\n"
         "      - {do: route, phase: work, waypoints: [{north_m: 30, east_m: 0, depth_m: 10}]}\n"
         "      - {do: route, phase: return, waypoints: [{north_m: 0, east_m: 0, depth_m: 10}]}\n";
}

struct Flown {
  std::unique_ptr<twin::Run> run;
  double ended_s = 0;
  const twin::AgentState& state(std::size_t i = 0) const { return run->states()[i]; }
  const twin::Agent& agent(std::size_t i = 0) const { return run->agents()[i]; }
  std::vector<ConductEvent> events(Kind kind, std::size_t i = 0) const {
    std::vector<ConductEvent> out;
    for (const ConductEvent& event : state(i).conduct.events)
      if (event.kind == kind) out.push_back(event);
    return out;
  }
};

Flown begun(const std::string& yaml, double step_s = 0.05) {
  twin::ReadyRun ready = ready_of(yaml);
  Flown flown;
  flown.run = std::make_unique<twin::Run>(std::move(ready.agents), std::move(ready.states),
                                          settings_of(step_s));
  return flown;
}

/// Until all have ended, or `most_s`.
Flown flown(const std::string& yaml, double most_s = 1800, double step_s = 0.05) {
  Flown out = begun(yaml, step_s);
  while (out.run->time_s() < most_s && !out.run->all_ended()) out.run->step();
  out.ended_s = out.run->time_s();
  return out;
}

TEST(Conduct, DoesItsTasksAndEnds) {
  const Flown done = flown(calm_head(0.05) + rov_on_a_line("{}"));
  EXPECT_TRUE(done.state().conduct.has_ended);
  EXPECT_FALSE(done.state().conduct.has_turned);
  EXPECT_EQ(done.state().halt, twin::Halt::none);
  EXPECT_EQ(done.events(Kind::finished).size(), 1U);
  // There and back again, 60 m at 0.5 m/s and a little more.
  EXPECT_GT(done.ended_s, 120);
  EXPECT_LT(done.ended_s, 150);
}

TEST(Conduct, TakesTheSameWayAsOneThatDoesNotConductItself) {
  const std::string plain = calm_head(0.05) + rov_on_a_line("{}");
  std::string without = plain;
  without.erase(without.find("    conduct: {}\n"), 16);
  Flown a = begun(plain), b = begun(without);
  for (int i = 0; i < 1500; ++i) {
    a.run->step();
    b.run->step();
  }
  const auto& here = a.state().vehicle.body.position_m;
  const auto& there = b.state().vehicle.body.position_m;
  EXPECT_EQ(here.x, there.x);
  EXPECT_EQ(here.z, there.z);
}

TEST(Conduct, HoldsWhileALinkThatItNeedsIsLostAndGoesOnWhereItWas) {
  const Flown held =
      flown(calm_head(0.05) + rov_on_a_line("{autonomy: shared, holding: {overlap_m: "
                                            "3}, faults: [{fault: lost_link, at_s: "
                                            "30, for_s: 60}]}"));
  ASSERT_EQ(held.events(Kind::hold_began).size(), 1U);
  EXPECT_EQ(held.events(Kind::hold_began)[0].cause, Cause::link);
  EXPECT_EQ(held.events(Kind::hold_began)[0].t_s, 30);
  ASSERT_EQ(held.events(Kind::went_back).size(), 1U);
  EXPECT_EQ(held.events(Kind::went_back)[0].t_s, 90);
  ASSERT_EQ(held.events(Kind::resumed).size(), 1U);
  EXPECT_FALSE(held.state().conduct.has_turned);
  EXPECT_NEAR(held.state().conduct.held_s, 60, 2);
  // Some 14 m on when the link was lost, and 3 m of them again.
  EXPECT_NEAR(held.state().conduct.left_m.x, 11, 1.5);
  const Flown straight = flown(calm_head(0.05) + rov_on_a_line("{}"));
  EXPECT_GT(held.ended_s, straight.ended_s + 60);
  EXPECT_LT(held.ended_s, straight.ended_s + 60 + 30);
}

TEST(Conduct, ByItselfItNeedsNoLink) {
  const Flown done =
      flown(calm_head(0.05) + rov_on_a_line("{faults: [{fault: lost_link, at_s: 30, for_s: 60}]}"));
  EXPECT_TRUE(done.events(Kind::hold_began).empty());
  EXPECT_EQ(done.events(Kind::fault_began).size(), 1U);
  EXPECT_EQ(done.events(Kind::fault_ended).size(), 1U);
}

TEST(Conduct, HoldsStillWhileItHolds) {
  Flown held = begun(head(0.05) + rov_on_a_line("{autonomy: shared, faults: [{fault: lost_link, "
                                                "at_s: 30}]}"));
  while (held.run->time_s() < 60) held.run->step();
  const auto at_a_minute = held.state().vehicle.body.position_m;
  while (held.run->time_s() < 120) held.run->step();
  EXPECT_LT(twin::length_of(held.state().vehicle.body.position_m - at_a_minute), 0.3);
}

TEST(Conduct, ComesHomeFromAHoldThatLastsTooLong) {
  const Flown home =
      flown(calm_head(0.05) +
            rov_on_a_line("{autonomy: shared, faults: [{fault: lost_link, at_s: 30}], behaviour: "
                          "{fallback: [{reactive: true, fallback: [{guard: {while: link_up, then: "
                          "{do: carry_on}}}, {timeout: {after_s: 45, then: {do: hold}}}]}, {do: "
                          "come_home}]}}"));
  ASSERT_EQ(home.events(Kind::turned_for_home).size(), 1U);
  EXPECT_EQ(home.events(Kind::turned_for_home)[0].cause, Cause::link);
  EXPECT_NEAR(home.events(Kind::turned_for_home)[0].t_s, 76, 1.01);
  EXPECT_EQ(home.events(Kind::came_home).size(), 1U);
  EXPECT_TRUE(home.state().conduct.has_turned);
  EXPECT_LT(twin::length_of(home.state().vehicle.body.position_m - twin::Triple<double>{0, 0, 10}),
            1.0);
}

TEST(Conduct, DoesNotBeginWhereALimitIsExceeded) {
  // 0.4 m/s at the surface, some 0.33 at 10 m.
  const Flown held = flown(head(0.05) + rov_on_a_line("{limits: [{current_speed_m_s: 0.3, phases: "
                                                      "[work], source: x, status: estimate}]}"),
                           300);
  ASSERT_EQ(held.events(Kind::hold_began).size(), 1U);
  EXPECT_EQ(held.events(Kind::hold_began)[0].cause, Cause::limit);
  EXPECT_EQ(held.events(Kind::hold_began)[0].detail, 0U);
  EXPECT_NEAR(held.events(Kind::hold_began)[0].value, std::hypot(0.325, 0.05), 0.01);
  EXPECT_EQ(held.state().mission.task, 0U);
  const Flown goes = flown(head(0.05) + rov_on_a_line("{limits: [{current_speed_m_s: 0.35}]}"));
  EXPECT_EQ(goes.events(Kind::finished).size(), 1U);
  EXPECT_NEAR(goes.state().conduct.most_share, 0.329 / 0.35, 0.03);
}

TEST(Conduct, TurnsForHomeWithTheReserveThatItIsToKeep) {
  // 18 Ah at 14.8 V are 0.96 MJ; a line of 600 m takes some 60 kJ.
  const auto yaml = [](double charge) {
    return calm_head(0.05) +
           "  - {name: rov, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: 10}, "
           "speed_m_s: 0.5, state_of_charge: " +
           std::to_string(charge) +
           ", conduct: {reserve: {share: 0.2, margin: 1.3}}, tasks: [{do: route, waypoints: "
           "[{north_m: 600, east_m: 0, depth_m: 10}]}, {do: route, phase: return, waypoints: "
           "[{north_m: 0, east_m: 0, depth_m: 10}]}]}\n";
  };
  const Flown full = flown(yaml(1), 4000);
  EXPECT_FALSE(full.state().conduct.has_turned);
  const double used = 1 - full.state().vehicle.battery.charge;
  ASSERT_GT(used, 0.02);
  // Enough for two thirds of it.
  const Flown home = flown(yaml(0.2 + 0.66 * used), 4000);
  ASSERT_EQ(home.events(Kind::turned_for_home).size(), 1U);
  EXPECT_EQ(home.events(Kind::turned_for_home)[0].cause, Cause::reserve);
  EXPECT_EQ(home.events(Kind::came_home).size(), 1U);
  EXPECT_GT(home.state().vehicle.battery.charge, 0.2);
  EXPECT_LT(home.state().vehicle.battery.charge, 0.2 + 0.2 * used);
}

TEST(Conduct, TurnsForHomeSoonerAgainstTheCurrent) {
  const auto yaml = [](double north_m_s) {
    return "name: t\nseed: 7\nduration: 60min\nstep_s: 0.05\nlog_every_s: 1\nwater: {made_up: "
           "{depth_m: 60, current: [{depth_m: 0, east_m_s: 0, north_m_s: " +
           std::to_string(north_m_s) +
           "}]}}\nvehicles:\n  - {name: rov, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, "
           "depth_m: 10}, speed_m_s: 0.5, state_of_charge: 0.3, conduct: {}, tasks: [{do: route, "
           "waypoints: [{north_m: 2000, east_m: 0, depth_m: 10}]}]}\n";
  };
  const Flown still = flown(yaml(0), 2000), swept = flown(yaml(0.4), 2000);
  ASSERT_EQ(still.events(Kind::turned_for_home).size(), 1U);
  ASSERT_EQ(swept.events(Kind::turned_for_home).size(), 1U);
  EXPECT_LT(swept.events(Kind::turned_for_home)[0].t_s,
            0.8 * still.events(Kind::turned_for_home)[0].t_s);
}

TEST(Conduct, ComesHomeWithoutAThruster) {
  Flown home = begun(calm_head(0.05) +
                     rov_on_a_line("{faults: [{fault: lost_thruster, at_s: 20, thruster: 4}]}"));
  while (home.run->time_s() < 30) home.run->step();
  EXPECT_EQ(home.state().vehicle.thrust_n[4], 0);
  while (home.run->time_s() < 300 && !home.run->all_ended()) home.run->step();
  ASSERT_EQ(home.events(Kind::turned_for_home).size(), 1U);
  EXPECT_EQ(home.events(Kind::turned_for_home)[0].cause, Cause::thruster);
  EXPECT_EQ(home.events(Kind::came_home).size(), 1U);
}

TEST(Conduct, AMultirotorHoldsWhileItsReceiverIsLost) {
  const Flown held = flown(
      calm_head(0.02) +
          "  - {name: uav, model: x500, start: {north_m: 0, east_m: 0, height_m: 20}, conduct: "
          "{faults: [{fault: lost_gnss, at_s: 5, for_s: 20}]}, tasks: [{do: route, waypoints: "
          "[{north_m: 60, east_m: 0, height_m: 20}]}]}\n",
      200, 0.02);
  ASSERT_EQ(held.events(Kind::hold_began).size(), 1U);
  EXPECT_EQ(held.events(Kind::hold_began)[0].cause, Cause::gnss);
  EXPECT_EQ(held.events(Kind::finished).size(), 1U);
}

/// Beside a monopile of 6 m, on a line from 20 m south of it.
std::string tethered(const std::string& conduct, const std::string& tasks,
                     const std::string& detail = "full") {
  return head(0.05) +
         "  - {name: rov, model: bluerov2_heavy, start: {north_m: -16, east_m: 0, depth_m: 10}, "
         "speed_m_s: 0.4, tether: {top: {north_m: -22, east_m: 0, depth_m: 0}, length_m: 70}, "
         "detail: " +
         detail + ", conduct: " + conduct + ", tasks: [" + tasks +
         "]}\nstructures:\n  - {name: pile, kind: cylinder, north_m: 0, east_m: 0, diameter_m: 6, "
         "top_height_m: 20, bottom_depth_m: 60, turns_current: true}\n";
}

TEST(Conduct, AFouledLineIsCaughtAndTheVehicleHolds) {
  for (const char* detail : {"full", "coarse"}) {
    SCOPED_TRACE(detail);
    Flown held = begun(tethered("{faults: [{fault: fouled_tether, at_s: 20, for_s: 60}]}",
                                "{do: route, waypoints: [{north_m: -16, east_m: 12, depth_m: 14}]}",
                                detail));
    while (held.run->time_s() < 40) held.run->step();
    ASSERT_TRUE(held.state().conduct.is_snagged);
    const std::size_t node = held.state().conduct.snag_node;
    const auto caught = held.state().tether.node_m[node];
    while (held.run->time_s() < 70) held.run->step();
    EXPECT_EQ(held.state().tether.node_m[node].x, caught.x);
    EXPECT_EQ(held.state().conduct.doing, twin::Doing::hold);
    while (held.run->time_s() < 400 && !held.run->all_ended()) held.run->step();
    EXPECT_EQ(held.events(Kind::finished).size(), 1U);
    EXPECT_FALSE(held.state().conduct.is_snagged);
  }
}

TEST(Conduct, AVehicleOnALineGoesBackRoundThePileTheWayItCame) {
  // Three quarters of a turn, and then a thruster fails.
  const Flown home = flown(
      tethered("{faults: [{fault: lost_thruster, at_s: 150, thruster: 4}]}",
               "{do: orbit, centre: {north_m: 0, east_m: 0, depth_m: 10}, radius_m: 8, from_deg: "
               "180, turns: 1, end_depth_m: 12, chord_m: 2}"),
      900);
  ASSERT_EQ(home.events(Kind::turned_for_home).size(), 1U);
  ASSERT_EQ(home.events(Kind::came_home).size(), 1U);
  EXPECT_EQ(home.state().halt, twin::Halt::none);
  EXPECT_EQ(home.state().tether.whole, 1);
  EXPECT_LT(std::abs(home.state().conduct.wound_rad), 0.2);
  // Home the short way it would have wound the line about the pile: a whole turn.
  const double flown_s = home.events(Kind::came_home)[0].t_s - 150;
  EXPECT_GT(flown_s, 40);
}

TEST(Conduct, StandsAboardForItsTimeAndGetsAnotherBattery) {
  const Flown done = flown(
      calm_head(0.02) +
          "  - {name: uav, model: x500, start: {north_m: 0, east_m: 0, height_m: 10}, "
          "state_of_charge: 0.6, conduct: {home: {north_m: 0, east_m: 0, height_m: 10}}, tasks: "
          "[{do: route, waypoints: [{north_m: 30, east_m: 0, height_m: 15}]}, {do: aboard, "
          "duration_s: 120, battery: swap}, {do: route, waypoints: [{north_m: -30, east_m: 0, "
          "height_m: 15}]}, {do: aboard, duration_s: 0}]}\n",
      600, 0.02);
  ASSERT_EQ(done.events(Kind::came_aboard).size(), 2U);
  ASSERT_EQ(done.events(Kind::launched).size(), 1U);
  EXPECT_NEAR(done.events(Kind::launched)[0].t_s - done.events(Kind::came_aboard)[0].t_s, 120, 2);
  EXPECT_EQ(done.events(Kind::finished).size(), 1U);
  EXPECT_GT(done.state().vehicle.battery.charge, 0.9);
  EXPECT_TRUE(done.state().conduct.is_aboard);
  EXPECT_EQ(done.state().halt, twin::Halt::none);
}

TEST(Conduct, IsChargedAsFastAsTheChargerGives) {
  Flown done = begun(
      calm_head(0.05) +
      "  - {name: rov, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: 2}, "
      "state_of_charge: 0.5, conduct: {}, tasks: [{do: aboard, duration: 10min, battery: charge, "
      "charger_w: 200}]}\n");
  const double full_j = done.agent().conduct->full_j;
  while (done.run->time_s() < 300) done.run->step();
  EXPECT_NEAR(done.state().vehicle.battery.charge, 0.5 + 200 * 300 / full_j, 0.003);
}

TEST(Conduct, IsCarriedLaunchedAndTakenBackByAVesselUnderWay) {
  const std::string yaml =
      calm_head(0.02) +
      "  - {name: usv, model: wamv16, start: {north_m: 0, east_m: 0, depth_m: 0}, speed_m_s: 1, "
      "tasks: [{do: route, waypoints: [{north_m: 400, east_m: 0, depth_m: 0}]}]}\n"
      "  - {name: uav, model: x500, start: {north_m: 0, east_m: 0, height_m: 3}, carrier: {name: "
      "usv, forward_m: 0, up_m: 3}, conduct: {}, tasks: [{do: aboard, duration_s: 60}, {do: route, "
      "waypoints: [{north_m: 80, east_m: 30, height_m: 20}]}, {do: aboard, duration_s: 30}]}\n";
  Flown flown = begun(yaml, 0.02);
  while (flown.run->time_s() < 55) flown.run->step();
  const auto apart = [&] {
    return flown.state(1).vehicle.body.position_m - flown.state(0).vehicle.body.position_m;
  };
  EXPECT_GT(flown.state(0).vehicle.body.position_m.x, 30);
  EXPECT_LT(std::hypot(apart().x, apart().y), 2.0);
  while (flown.run->time_s() < 70) flown.run->step();
  EXPECT_FALSE(flown.state(1).conduct.is_aboard);
  EXPECT_GT(twin::length_of(apart()), 4);
  while (flown.run->time_s() < 300 && !flown.state(1).conduct.has_ended) flown.run->step();
  EXPECT_TRUE(flown.state(1).conduct.has_ended);
  EXPECT_TRUE(flown.state(1).conduct.is_aboard);
  EXPECT_LT(std::hypot(apart().x, apart().y), 2.0);
  EXPECT_EQ(flown.state(1).halt, twin::Halt::none);
}

TEST(Conduct, SharedAutonomyKeepsAHastyPilotInsideItsEnvelope) {
  const auto fastest = [](const std::string& conduct) {
    Flown f = begun(calm_head(0.05) + rov_on_a_line(conduct));
    double most = 0;
    while (f.run->time_s() < 50) {
      f.run->step();
      most = std::max(most, twin::length_of(f.state().vehicle.body.nu.linear));
    }
    return most;
  };
  const std::string pilot = "pilot: {wander_m: 0, haste: 2}";
  EXPECT_GT(fastest("{autonomy: teleop, " + pilot + "}"), 0.8);
  EXPECT_LT(fastest("{autonomy: shared, " + pilot + ", envelope: {most_speed_m_s: 0.4}}"), 0.45);
}

TEST(Conduct, AWanderingHandLeavesTheSpeedOfTheWayAsItIs) {
  const auto once_round_s = [](const std::string& pilot) {
    return flown(tethered("{autonomy: teleop, " + pilot + "}",
                          "{do: orbit, centre: {north_m: 0, east_m: 0, depth_m: 10}, radius_m: "
                          "5.5, from_deg: 180, turns: 1, end_depth_m: 10, chord_m: 1.5, "
                          "speed_m_s: 0.06}"))
        .ended_s;
  };
  const double steady_s = once_round_s("pilot: {wander_m: 0}");
  EXPECT_NEAR(once_round_s("pilot: {wander_m: 0.3, memory_s: 8}"), steady_s, 0.06 * steady_s);
}

TEST(Conduct, SharedAutonomyKeepsAWanderingPilotOffThePile) {
  const auto nearest = [](const std::string& conduct) {
    Flown f = begun(tethered(conduct,
                             "{do: orbit, centre: {north_m: 0, east_m: 0, depth_m: 10}, radius_m: "
                             "5.5, from_deg: 180, turns: 0.5, end_depth_m: 10, chord_m: 1}"));
    double least = 100;
    while (f.run->time_s() < 120 && f.state().halt == twin::Halt::none) {
      f.run->step();
      const auto& p = f.state().vehicle.body.position_m;
      least = std::min(least, std::hypot(p.x, p.y) - 3);
    }
    return least;
  };
  const std::string pilot = "pilot: {wander_m: 1.2, memory_s: 8}";
  const double alone = nearest("{autonomy: teleop, " + pilot + "}");
  const double shared = nearest("{autonomy: shared, " + pilot + ", envelope: {stand_off_m: 1.8}}");
  EXPECT_LT(alone, 1.0);
  EXPECT_GT(shared, 1.2);
}

TEST(Conduct, IsTheSameToTheBitHoweverItIsSteppedAndTakenUpInAHold) {
  std::string yaml = head(0.05,
                          "{partitions: [{significant_height_m: 0.5, peak_period_s: 6, "
                          "from_deg: 250}], components: 8}",
                          "dryden");
  for (int i = 0; i < 3; ++i)
    yaml += rov_on_a_line(
                "{autonomy: shared, pilot: {wander_m: 0.2}, limits: "
                "[{current_speed_m_s: 0.6}], faults: [{fault: lost_link, at_s: 20, "
                "for_s: 30}]}")
                .replace(10, 3, "rov" + std::to_string(i));
  const auto made = [&](std::size_t threads, bool is_batch) {
    twin::ReadyRun ready = ready_of(yaml);
    twin::RunSettings settings = settings_of(0.05);
    settings.threads = threads;
    settings.is_batch = is_batch;
    return std::make_unique<twin::Run>(std::move(ready.agents), std::move(ready.states), settings);
  };
  twin::RunLog first, second, third, taken_up;
  auto a = made(1, true), b = made(2, true), c = made(1, false), d = made(1, true);
  step_and_log(*a, 1600, first);
  step_and_log(*b, 1600, second);
  step_and_log(*c, 1600, third);
  expect_same_bits(first, second, "two threads");
  expect_same_bits(first, third, "one by one");
  step_and_log(*d, 600, taken_up);
  ASSERT_EQ(d->states()[0].conduct.doing, twin::Doing::hold);
  auto e = made(1, true);
  e->restore(d->checkpoint());
  step_and_log(*e, 1000, taken_up);
  expect_same_bits(first, taken_up, "taken up in the hold");
}

TEST(Conduct, RefusesWhatNobodyKnowsAndWhatItDoesNotHave) {
  const auto message = [](const std::string& conduct, const std::string& model = "bluerov2_heavy") {
    try {
      std::string yaml = calm_head(0.05) + rov_on_a_line(conduct);
      yaml.replace(yaml.find("bluerov2_heavy"), 14, model);
      (void)ready_of(yaml);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_NE(message("{limits: [{least_visibility_m: 500}]}").find("--assume visibility_m"),
            std::string::npos);
  EXPECT_EQ(message("{limits: [{least_visibility_m: 500, if_missing: not_checked}]}"), "no error");
  EXPECT_EQ(message("{limits: [{least_visibility_m: 500}], assume: {visibility_m: 900}}"),
            "no error");
  EXPECT_NE(message("{limits: [{deck_motion_m: 1}]}").find("deck_point"), std::string::npos);
  EXPECT_NE(message("{limits: [{current_speed_m_s: 0.2, wind_speed_m_s: 3}]}").find("found beside"),
            std::string::npos);
  EXPECT_NE(message("{limits: [{speed: 0.2}]}").find("without a variable"), std::string::npos);
  EXPECT_NE(message("{limits: [{current_speed_m_s: 0.2}, {least_current_speed_m_s: 0.4}]}")
                .find("at the same time"),
            std::string::npos);
  EXPECT_NE(
      message("{faults: [{fault: lost_thruster, at_s: 1, thruster: 12}]}").find("expected 0 to 7"),
      std::string::npos);
  EXPECT_NE(message("{faults: [{fault: fouled_tether, at_s: 1}]}").find("tether"),
            std::string::npos);
  EXPECT_NE(message("{faults: [{fault: lost_gnss, at_s: 1}]}").find("receiver"), std::string::npos);
  EXPECT_NE(message("{faults: [{fault: lost_mind, at_s: 1}]}").find("lost_mind"),
            std::string::npos);
  EXPECT_NE(message("{assume: {current_speed_m_s: 1}}").find("cannot be assumed"),
            std::string::npos);
  EXPECT_NE(message("{pilot: {haste: 2}}").find("autonomy"), std::string::npos);
}

TEST(WayRound, KeepsOffWhatStandsBetweenAndIsStraightElsewhere) {
  const std::vector<twin::Structure> piles{twin::Cylinder{0, 0, 3, -20, 40},
                                           twin::Cylinder{30, 2, 3, -20, 40}};
  Rng rng(7, "way round");
  for (int i = 0; i < 500; ++i) {
    const auto place = [&] {
      while (true) {
        const twin::Triple<double> p{rng.uniform(-30, 60), rng.uniform(-30, 30), 10};
        if (signed_distance_m(piles[0], p) > 2.2 && signed_distance_m(piles[1], p) > 2.2) return p;
      }
    };
    const twin::Triple<double> from = place(), to = place();
    twin::Triple<double> before = from;
    double length_m = 0;
    for (const twin::Waypoint& at : twin::way_round(from, to, piles, 2)) {
      for (const twin::Structure& pile : piles)
        EXPECT_GT(twin::least_distance_m(pile, before, at.position_m), 1.99) << i;
      length_m += twin::length_of(at.position_m - before);
      before = at.position_m;
    }
    EXPECT_EQ(before.x, to.x);
    EXPECT_EQ(before.z, to.z);
    // No longer than the straight way and half round both.
    EXPECT_LT(length_m, twin::length_of(to - from) + 2 * (3.1416 - 2) * 5.2 + 4) << i;
  }
}

}  // namespace
}  // namespace slackwater::tests::conduct_test
