#include "twin/scenario/expand_mission.h"

#include <gtest/gtest.h>

#include "fields/base/error.h"
#include "tests/support/error_of.h"
#include "tests/twin/mission/mission_for_tests.h"
#include "tests/twin/run/run_for_tests.h"
#include "twin/mission/work_pattern.h"

namespace slackwater::tests::expand_mission_test {
namespace {

std::string mission(const std::string& task, const std::string& turbine = "A01",
                    const std::string& more = "") {
  return "name: test\nseed: 7\nduration: 3h\nstep_s: 0.05\nlog_every_s: 1\nwater: {made_up: "
         "{depth_m: 35, current: [{depth_m: 0, east_m_s: 0.1, north_m_s: 0.1}], wind: {speed_m_s: "
         "4, from_deg: 270}}}\ntasks: [" +
         task + "]\nturbines: [" + turbine + "]\n" + more;
}

twin::ExpandedMission expanded(const std::string& yaml) {
  const Config config = Config::parse(yaml, "mission.yaml");
  twin::ExpandedMission out = twin::expand_mission(config, small_farm_parts());
  config.expect_all_read();
  return out;
}

class EachTask : public testing::TestWithParam<const char*> {};

TEST_P(EachTask, IsLaidOutWhereItsVehiclesCanGo) {
  const std::string task = GetParam();
  const auto out = expanded(mission(task, task == "mooring_tendon" ? "F01" : "A01"));
  const twin::Scenario& scenario = out.scenario;
  twin::Surround surround = surround_of(scenario);
  const UtcTime from = parse_utc("2025-06-02T06:00:00Z");
  surround.field = twin::made_up_field(std::get<twin::MadeUpWater>(scenario.water), surround.site,
                                       from, from + std::chrono::hours(4));
  // Checks that no start is in a structure and no way leads through one.
  twin::ReadyRun ready;
  try {
    ready = twin::set_up(scenario, surround);
  } catch (const Error& error) {
    FAIL() << error.what() << "\n" << scenario.yaml;
  }
  EXPECT_EQ(ready.agents.size(), out.workers.size());
  for (const twin::ScenarioVehicle& vehicle : scenario.vehicles) {
    ASSERT_TRUE(vehicle.conduct);
    EXPECT_FALSE(vehicle.conduct->limits.empty());
    double work_m = 0;
    twin::Triple<double> before = vehicle.start_m;
    for (const twin::ScenarioTask& t : vehicle.tasks)
      for (const twin::Waypoint& at : t.waypoints) {
        if (t.phase == twin::Phase::work) work_m += twin::length_of(at.position_m - before);
        before = at.position_m;
      }
    EXPECT_GT(work_m, 29) << vehicle.name;
    // Home at the end.
    EXPECT_LT(twin::length_of(before - vehicle.start_m), 1) << vehicle.name;
  }
}
INSTANTIATE_TEST_SUITE_P(Tasks, EachTask,
                         testing::Values("blade_scan", "tower_tp_check", "scour_survey",
                                         "cable_burial", "cp_anode", "mooring_tendon", "biofouling",
                                         "access_window", "mmez", "mob_drill"),
                         [](const auto& tested) { return std::string(tested.param); });

TEST(ExpandMission, StepsATetherCoarselyUnlessTheMissionWantsItInFull) {
  const auto detail_of = [](const std::string& yaml) {
    return expanded(yaml).scenario.vehicles[0].detail;
  };
  using twin::StepDetail;
  EXPECT_EQ(detail_of(mission("scour_survey")), StepDetail::coarse);
  EXPECT_EQ(detail_of(mission("scour_survey", "A01", "agents: {surveyor: {detail: full}}\n")),
            StepDetail::full);
  // No tether, nothing to save.
  EXPECT_EQ(detail_of(mission("blade_scan")), StepDetail::full);
}

TEST(ExpandMission, WavesOfAForecastErrUnlessTheMissionOrTheCallerSaysOtherwise) {
  const auto errs = [](const std::string& water, const std::string& waves,
                       std::optional<bool> wanted) {
    const Config config =
        Config::parse("name: test\nseed: 7\nduration: 3h\nstep_s: 0.05\nwater: " + water +
                          "\ntasks: [blade_scan]\nturbines: [A01]\n" + waves,
                      "mission.yaml");
    twin::MissionParts parts = small_farm_parts();
    parts.height_errors = wanted;
    const twin::Scenario scenario = twin::expand_mission(config, parts).scenario;
    config.expect_all_read();
    if (waves.find("components") != std::string::npos) {
      EXPECT_EQ(scenario.waves.components, 8U);
    }
    return scenario.waves.have_height_errors;
  };
  const std::string forecast = "{forecast: {site: a}}", made_up = "{made_up: {depth_m: 35}}";
  EXPECT_TRUE(errs(forecast, "", {}));
  EXPECT_TRUE(errs(forecast, "waves: {components: 8}\n", {}));
  EXPECT_TRUE(errs(forecast, "waves: {from: forecast, components: 8}\n", {}));
  EXPECT_FALSE(errs(forecast, "waves: {height_errors: false}\n", {}));
  EXPECT_FALSE(errs(forecast, "waves: {components: 8}\n", false));
  EXPECT_TRUE(errs(forecast, "waves: {height_errors: false}\n", true));
  for (const std::optional<bool> wanted : {std::optional<bool>(), std::optional<bool>(true)}) {
    EXPECT_FALSE(errs(forecast, "waves: {from: calm}\n", wanted));
    EXPECT_FALSE(errs(forecast,
                      "waves: {components: 8, partitions: [{significant_height_m: 1, "
                      "peak_period_s: 6, from_deg: 0}]}\n",
                      wanted));
    EXPECT_FALSE(errs(made_up, "waves: {from: calm}\n", wanted));
    EXPECT_FALSE(errs(made_up, "", wanted));
  }
}

TEST(ExpandMission, GoesToSeveralTurbinesAndGetsABatteryBetweenThem) {
  const auto out = expanded(mission("tower_tp_check", "A01, A02"));
  const auto scenario = out.scenario;
  std::size_t swaps = 0, aboard = 0;
  for (const twin::ScenarioTask& task : scenario.vehicles[0].tasks) {
    if (task.kind != twin::ScenarioTask::Kind::aboard) continue;
    ++aboard;
    if (task.charger_w > 0) ++swaps;
  }
  // Two patterns at each of two turbines: three swaps between four sorties.
  EXPECT_EQ(swaps, 3U);
  EXPECT_EQ(aboard, 5U);
}

/// A survey from a vessel, at two turbines.
std::string from_a_vessel(const std::string& agent, const std::string& vessel) {
  return mission("scour_survey", "A01, A02",
                 "agents: {surveyor: " + agent + "}\nvehicles:\n  - " + vessel + "\n");
}
const std::string by_tender =
    "{carrier: {name: tender, forward_m: -4, starboard_m: 6, up_m: 2}, swap: 10min}";

TEST(ExpandMission, AVesselTakesATetheredVehicleFromTurbineToTurbine) {
  const auto out = expanded(from_a_vessel(
      by_tender,
      "{name: tender, model: ctv24, speed_m_s: 4, stands: {bearing_deg: 180, distance_m: 27}}"));
  const auto scenario = out.scenario;
  ASSERT_EQ(scenario.vehicles.size(), 2U);
  const twin::ScenarioVehicle &rov = scenario.vehicles[0], &tender = scenario.vehicles[1];
  ASSERT_TRUE(rov.carrier);
  EXPECT_EQ(rov.carrier->name, "tender");
  EXPECT_FALSE(rov.tether->top_m);
  EXPECT_EQ(rov.tether->length_m, 90);
  EXPECT_EQ(out.workers, std::vector<std::string>{"surveyor"});
  // She stands 30 m south of each axis, and goes there by herself.
  using Kind = twin::ScenarioTask::Kind;
  ASSERT_EQ(tender.tasks.size(), 3U);
  EXPECT_EQ(tender.tasks[0].kind, Kind::stand_by);
  EXPECT_EQ(tender.tasks[1].kind, Kind::route);
  EXPECT_EQ(tender.tasks[2].kind, Kind::stand_by);
  EXPECT_NEAR(tender.start_m.x, -30, 1e-6);
  EXPECT_NEAR(tender.tasks[1].waypoints.back().position_m.x, 70, 1e-6);
  EXPECT_NEAR(tender.tasks[1].waypoints.back().position_m.y, 700, 1e-6);
  // At each turbine it waits for her, is launched, works there, and is taken aboard beside her.
  std::vector<std::size_t> waits, swaps;
  for (std::size_t i = 0; i < rov.tasks.size(); ++i) {
    if (rov.tasks[i].until_stand_by) waits.push_back(i);
    if (rov.tasks[i].charger_w > 0) swaps.push_back(i);
  }
  ASSERT_EQ(waits.size(), 2U);
  EXPECT_EQ(waits[0], 0U);
  EXPECT_EQ(swaps, std::vector<std::size_t>{waits[1]});
  EXPECT_EQ(rov.tasks[waits[1]].hold_s, 600);
  for (std::size_t i = 0; i < rov.tasks.size(); ++i) {
    const double axis_m = i < waits[1] ? 0 : 700;
    for (const twin::Waypoint& at : rov.tasks[i].waypoints)
      EXPECT_LT(std::abs(at.position_m.y - axis_m), 15) << i;
    if (rov.tasks[i].phase == twin::Phase::recovery) {
      EXPECT_NEAR(rov.tasks[i - 1].waypoints.back().position_m.x, i < waits[1] ? -30 : 70, 1e-6);
    }
  }
  EXPECT_EQ(rov.tasks.back().kind, Kind::aboard);
}

TEST(ExpandMission, ACarrierThatComesFromHarbourGoesBackThere) {
  const auto out = expanded(from_a_vessel(
      by_tender, "{name: tender, model: ctv24, start: {north_m: -900, east_m: 20, depth_m: 0}}"));
  const auto scenario = out.scenario;
  const twin::ScenarioVehicle& tender = scenario.vehicles[1];
  ASSERT_EQ(tender.tasks.size(), 5U);
  // Where the task has the top of the tether: 22 m off the face.
  EXPECT_NEAR(tender.tasks[0].waypoints.back().position_m.x, -25, 1e-6);
  EXPECT_NEAR(tender.tasks[4].waypoints.back().position_m.x, -900, 1e-6);
}

TEST(ExpandMission, SaysWhatATetherAtSeveralTurbinesNeeds) {
  const auto message = [](const std::string& yaml) {
    return error_of([&] { return expanded(yaml); });
  };
  const std::string vessel = "{name: tender, model: ctv24}";
  EXPECT_EQ(message(from_a_vessel(by_tender, vessel)), "no error");
  EXPECT_NE(message(from_a_vessel("{state_of_charge: 0.9}", vessel))
                .find("name a vessel that takes it from one to the next"),
            std::string::npos);
  EXPECT_NE(message(from_a_vessel("{carrier: {name: tendr}}", vessel)).find("vehicles: tender"),
            std::string::npos);
  EXPECT_NE(message(mission("scour_survey", "A01", "agents: {surveyor: {carrier: {name: x}}}\n"))
                .find("of which there is none"),
            std::string::npos);
  EXPECT_NE(message(from_a_vessel(by_tender, "{name: tender, model: ctv24, tasks: [{do: hold}]}"))
                .find("leave them out"),
            std::string::npos);
}

TEST(ExpandMission, AMisspeltPlaceOnACarrierIsRefused) {
  EXPECT_NE(error_of([] {
              return expanded(
                  from_a_vessel("{carrier: {name: tender, forward_m: -4, starbord_m: 6, up_m: 2}}",
                                "{name: tender, model: ctv24}"));
            }).find("did you mean 'starboard_m'?"),
            std::string::npos);
}

// Else its log could not be replayed.
TEST(ExpandMission, WhatAScenarioMayNotSayIsNotLaidOut) {
  const auto message = [](const auto& change) {
    return error_of([&] {
      twin::MissionParts parts = small_farm_parts();
      change(parts.site.turbines[1]);
      const std::string yaml = mission("blade_scan");
      return twin::expand_mission(Config::parse(yaml, "mission.yaml"), parts);
    });
  };
  using Turbine = twin::WorkTurbine;
  EXPECT_EQ(message([](Turbine&) {}), "no error");
  EXPECT_NE(message([](Turbine& t) {
              t.radius_m = 56.5;
            }).find("turbine A02: found a foundation 113 m wide, expected 0.1 to 100 m"),
            std::string::npos);
  EXPECT_NE(message([](Turbine& t) {
              t.north_m = 60e3;
            }).find("turbine A02 stands too far away; expected it within 50 km"),
            std::string::npos);
  EXPECT_NE(message([](Turbine& t) {
              t.top_m = t.hub_m = -600;
            }).find("turbine A02: found its top at 600 m"),
            std::string::npos);
}

TEST(ExpandMission, WhatTheMissionSaysOfAnAgentTakesTheTasksPlace) {
  const auto out =
      expanded(mission("scour_survey", "A01",
                       "agents: {surveyor: {autonomy: shared, state_of_charge: 0.5, limits: "
                       "[{current_speed_m_s: 0.3}], faults: [{fault: lost_link, at: 1min}]}}\n"));
  const auto scenario = out.scenario;
  const twin::ScenarioVehicle& vehicle = scenario.vehicles[0];
  EXPECT_EQ(vehicle.conduct->autonomy, twin::Autonomy::shared);
  EXPECT_EQ(vehicle.conduct->limits.size(), 1U);
  EXPECT_EQ(vehicle.conduct->faults.size(), 1U);
  EXPECT_EQ(vehicle.state_of_charge, 0.5);
}

TEST(ExpandMission, PutsTheTasksOfSeveralTeamsIntoOneRun) {
  const auto out = expanded(
      mission("cp_anode, tower_tp_check", "A01",
              "vehicles:\n  - {name: guard, model: wamv16, start: {north_m: 300, east_m: 0, "
              "depth_m: 0}, tasks: [{do: hold}]}\n"));
  const auto scenario = out.scenario;
  ASSERT_EQ(scenario.vehicles.size(), 3U);
  EXPECT_EQ(scenario.vehicles[2].name, "guard");
  EXPECT_EQ(out.workers, (std::vector<std::string>{"inspector", "climber"}));
}

TEST(ExpandMission, RefusesWhatTheSiteDoesNotHave) {
  const auto message = [](const std::string& yaml) {
    return error_of([&] { return expanded(yaml); });
  };
  EXPECT_NE(message(mission("scour_survey", "B07")).find("the site has A01, A02, F01"),
            std::string::npos);
  EXPECT_NE(message(mission("mooring_tendon", "A01")).find("does not have"), std::string::npos);
  EXPECT_NE(message(mission("scour_survey", "")).find("name at least one"), std::string::npos);
  EXPECT_NE(message(mission("scour_survey, biofouling, scour_survey")).find("two tasks"),
            std::string::npos);
  EXPECT_NE(message(mission("scour_survey", "A01", "agents: {surveyer: {model: x500}}\n"))
                .find("surveyer"),
            std::string::npos);
  EXPECT_NE(message(mission("scour_survey", "A01", "agent: 3\n")).find("did you mean"),
            std::string::npos);
}

double length_of_work(const std::vector<twin::WorkLeg>& legs) {
  double length_m = 0;
  for (const twin::WorkLeg& leg : legs)
    for (std::size_t i = 1; i < leg.waypoints.size(); ++i)
      length_m += twin::length_of(leg.waypoints[i].position_m - leg.waypoints[i - 1].position_m);
  return length_m;
}

TEST(WorkPattern, RingsGoRoundAsOftenOneWayAsTheOther) {
  const twin::WorkSite site = small_farm();
  for (const double lowest : {12.0, 14.0, 17.0}) {
    const Config work = Config::parse(
        "pattern: rings\nstand_off_m: 2\nfrom: {depth_m: 10}\nto: "
        "{depth_m: " +
            std::to_string(lowest) + "}\nspacing_m: 1.5\n",
        "work.yaml");
    double wound = 0;
    twin::Triple<double> before;
    bool is_first = true;
    for (const twin::WorkLeg& leg : twin::lay_out(work, site, site.turbines[0]))
      for (const twin::Waypoint& at : leg.waypoints) {
        EXPECT_NEAR(std::hypot(at.position_m.x, at.position_m.y), 5, 1e-9);
        const double b = std::atan2(at.position_m.y, at.position_m.x);
        if (!is_first)
          wound += std::remainder(b - std::atan2(before.y, before.x), 2 * 3.141592653589793);
        before = at.position_m;
        is_first = false;
      }
    EXPECT_NEAR(wound, 0, 1e-9);
  }
}

TEST(WorkPattern, BandsTakeTheTimeThatTheirAreaTakesTheTool) {
  const twin::WorkSite site = small_farm();
  const Config work = Config::parse(
      "pattern: bands\nstand_off_m: 0.5\nfrom: {depth_m: 5}\nto: {depth_m: "
      "6.2}\nswath_m: 0.4\nrate_m2_h: 60\n",
      "work.yaml");
  double time_s = 0;
  for (const twin::WorkLeg& leg : twin::lay_out(work, site, site.turbines[0]))
    time_s += length_of_work({leg}) / leg.waypoints.front().speed_m_s;
  // Four rings of 0.4 m about a pile of 6 m: 30.2 m2 at 60 m2/h; chords are a little shorter.
  EXPECT_NEAR(time_s, 3600 * 4 * 0.4 * 6 * 3.141592653589793 / 60, 30);
}

TEST(WorkPattern, ABladeIsSeenFromItsFourSides) {
  const twin::WorkSite site = small_farm();
  const Config work = Config::parse(
      "pattern: blade\nblade: 1\nstand_off_m: 10\nrotor_faces_deg: 270\n", "work.yaml");
  const auto legs = twin::lay_out(work, site, site.turbines[0]);
  ASSERT_EQ(legs.size(), 1U);
  ASSERT_EQ(legs[0].waypoints.size(), 8U);
  // The first blade stands up, the rotor faces west, 5 m before the axis: its leading edge is to
  // the right as seen from upwind, south.
  const auto& tip = legs[0].waypoints[1].position_m;
  EXPECT_NEAR(tip.z, -90 - 63, 1e-9);
  EXPECT_NEAR(tip.x, -10, 1e-9);
  EXPECT_NEAR(tip.y, -5, 1e-9);
  for (const twin::Waypoint& at : legs[0].waypoints) EXPECT_LE(at.position_m.z, -90 - 4 + 1e-9);
}

TEST(WorkPattern, TheExpandingSquareGrowsByItsLeg) {
  const twin::WorkSite site = small_farm();
  const Config work = Config::parse(
      "pattern: square\ndistance_m: 50\nat: {depth_m: 0}\nleg_m: "
      "10\nlegs: 6\n",
      "work.yaml");
  EXPECT_NEAR(length_of_work(twin::lay_out(work, site, site.turbines[0])),
              10 * (1 + 1 + 2 + 2 + 3 + 3), 1e-9);
}

TEST(ExpandMission, NamesAreTakenAsTheyAreHoweverOddTheyLook) {
  twin::MissionParts parts = small_farm_parts();
  parts.site.turbines.front().id = "A: 1, {north} #2";
  const Config config =
      Config::parse(mission("scour_survey", "\"A: 1, {north} #2\""), "mission.yaml");
  const twin::ExpandedMission out = twin::expand_mission(config, parts);
  const twin::Scenario scenario = out.scenario;
  ASSERT_FALSE(scenario.structures.empty());
  EXPECT_EQ(scenario.structures.front().name, "A: 1, {north} #2");
}

}  // namespace
}  // namespace slackwater::tests::expand_mission_test
