#include "fields/base/error.h"
#include "fields/base/text.h"
#include "tests/twin/run/run_for_tests.h"
#include "twin/agent/conduct.h"
#include "twin/rehearse/flight.h"

namespace slackwater::tests::noisy_work_in_a_run_test {
namespace {

using twin::Cause;
using twin::ConductEvent;
using Kind = twin::ConductEventKind;

const std::string head_of_run =
    "name: test\nseed: 3\nduration: 20min\nstep_s: 0.1\nlog_every_s: 1\nwater: {made_up: {depth_m: "
    "40}}\nwaves: {from: calm}\nvehicles:\n";
const std::string worker =
    "  - {name: worker, model: wamv16, start: {north_m: 0, east_m: 0, depth_m: 0}, speed_m_s: 1, "
    "conduct: {}, tasks: [{do: route, phase: work, waypoints: [{north_m: 600, east_m: 0, depth_m: "
    "0}]}, {do: route, phase: return, waypoints: [{north_m: 600, east_m: 60, depth_m: 0}]}]}\n";
std::string watch(const std::string& more = ", noise_by: worker", const std::string& hold = "") {
  return "  - {name: watch, model: ctv24, start: {north_m: -100, east_m: 300, depth_m: 0}, "
         "conduct: {mammals: {animal: harbour_porpoise, watch: observer, count: 1, half_side_m: "
         "1000, radius_m: 300, clear_for_s: 60, again_after_s: 40, noise_for_s: 60, noise: "
         "{north_m: 0, east_m: 0}}" +
         more + "}, tasks: [{do: hold" + hold + "}]}\n";
}

/// An animal that swims north past the place of the noise and is always seen: at -500 m, 2 m/s, so
/// that it is within 300 m from 100 s to 400 s. Far off where there is none.
void plant(twin::ReadyRun& ready, double north_m = -500) {
  for (std::size_t i = 0; i < ready.agents.size(); ++i) {
    if (!ready.agents[i].conduct->plan.mammals) continue;
    twin::ReadyConduct changed = *ready.agents[i].conduct;
    twin::MammalDuty& duty = *changed.plan.mammals;
    duty.kind.speed_m_s = 2;
    duty.kind.turns_every_s = 1e15;
    duty.kind.surfaces_every_s = 1e-6;
    for (twin::CueSight& sight : duty.sight.by_force) sight = {1e12, 1};
    ready.agents[i].conduct = std::make_shared<const twin::ReadyConduct>(changed);
    twin::Mammal& animal = ready.states[i].conduct.mammals.mammals.animals.at(0);
    animal.position_m = {north_m, 0, 0};
    animal.course_rad = 0;
  }
}

std::unique_ptr<twin::Run> run_of(const std::string& yaml, double north_m = -500,
                                  std::size_t threads = 1, bool is_batch = true) {
  twin::ReadyRun ready = ready_of(yaml);
  plant(ready, north_m);
  return begun(std::move(ready), 0.1, threads, is_batch);
}

std::size_t place_of(const twin::Run& run, const std::string& name) {
  for (std::size_t i = 0; i < run.agents().size(); ++i)
    if (run.agents()[i].name == name) return i;
  return 99;
}

/// Of the worker: what it did but for its phases.
std::vector<ConductEvent> events_of(twin::Run& run) {
  std::vector<ConductEvent> events;
  for (const ConductEvent& event : run.states()[place_of(run, "worker")].conduct.events)
    if (event.kind != Kind::phase_began) events.push_back(event);
  return events;
}

void fly(twin::Run& run, double to_s = 1200) {
  while (run.time_s() < to_s - 0.01) run.step();
}

TEST(NoisyWorkInARun, IsHeldATickAfterTheFirstSightingAndGoesOnWhenTheZoneHasBeenClear) {
  const auto run = run_of(head_of_run + worker + watch());
  fly(*run);
  const auto events = events_of(*run);
  ASSERT_GE(events.size(), 5U);
  // The watch reports for the first time at 2 s, of the second before.
  EXPECT_EQ(events[0].kind, Kind::hold_began);
  EXPECT_EQ(events[0].cause, Cause::no_watch);
  EXPECT_EQ(events[0].t_s, 0);
  EXPECT_EQ(events[1].t_s, 61);
  EXPECT_EQ(events[1].kind, Kind::resumed);
  // Seen at 100 s, heard at 101 s.
  EXPECT_EQ(events[2].kind, Kind::hold_began);
  EXPECT_EQ(events[2].cause, Cause::mammal);
  EXPECT_EQ(events[2].t_s, 101);
  // Last seen at 400 s.
  EXPECT_TRUE(events[3].kind == Kind::went_back || events[3].kind == Kind::resumed);
  EXPECT_EQ(events[3].t_s, 440);
  EXPECT_EQ(events.back().kind, Kind::finished);
  const twin::AgentState& state = run->states()[0];
  EXPECT_EQ(state.conduct.noisy.stops, 1);
  const twin::MammalDutyState* const watches[] = {&run->states()[1].conduct.mammals};
  const twin::NoiseRecord record = noise_made(state.conduct.noisy, watches, 1200, 1);
  // Within the radius since some time in the second that ended at 100 s.
  EXPECT_EQ(record.exposed_s, 2);
  EXPECT_EQ(record.noisy_s[0], 61);
  EXPECT_EQ(record.noisy_s[1], 101);
}

TEST(NoisyWorkInARun, GoesOnAtThePlaceWhereItLeft) {
  const auto run = run_of(head_of_run + worker + watch());
  fly(*run, 100.9);
  const double left_m = run->states()[0].vehicle.body.position_m.x;
  EXPECT_GT(left_m, 15);
  const auto held = run->states()[0].mission;
  while (run->states()[0].conduct.doing != twin::Doing::task || run->time_s() < 200) run->step();
  EXPECT_EQ(run->states()[0].mission.route.next(), held.route.next());
  // No farther on than it was, and at most the overlap and a boat's way of stopping behind.
  EXPECT_NEAR(run->states()[0].vehicle.body.position_m.x, left_m, 6);
}

TEST(NoisyWorkInARun, IsTheSameWhoeverStandsFirst) {
  const auto one = run_of(head_of_run + worker + watch());
  const auto other = run_of(head_of_run + watch() + worker);
  fly(*one, 600);
  fly(*other, 600);
  const auto a = events_of(*one), b = events_of(*other);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].t_s, b[i].t_s);
    EXPECT_EQ(a[i].kind, b[i].kind);
  }
  EXPECT_EQ(one->states()[0].vehicle.body.position_m.x,
            other->states()[1].vehicle.body.position_m.x);
}

TEST(NoisyWorkInARun, IsTheSameToTheBitHoweverItIsSteppedAndTakenUpInTheHold) {
  const std::string yaml = head_of_run + worker + watch();
  const auto first = run_of(yaml), threads = run_of(yaml, -500, 2),
             single = run_of(yaml, -500, 1, false), before = run_of(yaml), after = run_of(yaml);
  fly(*first, 500);
  fly(*threads, 500);
  fly(*single, 500);
  fly(*before, 200);
  after->restore(before->checkpoint());
  fly(*after, 500);
  for (const auto* run : {&threads, &single, &after}) {
    const twin::AgentState& a = first->states()[0];
    const twin::AgentState& b = (*run)->states()[0];
    EXPECT_EQ(a.vehicle.body.position_m.x, b.vehicle.body.position_m.x);
    EXPECT_EQ(a.conduct.noisy.noisy_s, b.conduct.noisy.noisy_s);
    EXPECT_EQ(a.conduct.noisy.clear_since_s, b.conduct.noisy.clear_since_s);
  }
}

TEST(NoisyWorkInARun, StopsWithTheWatch) {
  // The watch ends after three minutes; no animal comes near.
  const auto run =
      run_of(head_of_run + worker + watch(", noise_by: worker", ", duration: 3min"), -990);
  fly(*run, 400);
  const auto events = events_of(*run);
  ASSERT_GE(events.size(), 3U);
  EXPECT_EQ(events[2].kind, Kind::hold_began);
  EXPECT_EQ(events[2].cause, Cause::no_watch);
  EXPECT_NEAR(events[2].t_s, 181, 2);
  EXPECT_EQ(run->states()[0].conduct.noisy.stops, 0);
}

TEST(NoisyWorkInARun, WithoutATieTheWorkerGoesAsIfItWereAlone) {
  const auto tied_to_none = run_of(head_of_run + worker + watch(""));
  twin::ReadyRun ready = ready_of(head_of_run + worker);
  twin::Run alone(std::move(ready.agents), std::move(ready.states), settings_of(0.1));
  fly(*tied_to_none, 300);
  fly(alone, 300);
  EXPECT_EQ(tied_to_none->states()[0].vehicle.body.position_m.x,
            alone.states()[0].vehicle.body.position_m.x);
  EXPECT_TRUE(tied_to_none->states()[0].conduct.noisy.noisy_s.empty());
}

TEST(NoisyWorkInAFlight, IsToldWithTheNameOfWhoseWorkItWas) {
  std::string yaml = head_of_run + worker + watch(", noise_by: worker", ", duration: 2min");
  for (const auto& [what, instead] : {std::pair{"duration: 20min", "duration: 3min"},
                                      {"north_m: 600", "north_m: 40"},
                                      {"north_m: 600, east_m: 60", "north_m: 60, east_m: 0"},
                                      {"clear_for_s: 60", "clear_for_s: 20"}})
    yaml.replace(yaml.find(what), std::string(what).size(), instead);
  const twin::Scenario scenario = twin::parse_scenario(yaml, "test.yaml");
  const twin::FlightCase cases[] = {{parse_utc("2025-06-02T06:00:00Z"), 0},
                                    {parse_utc("2025-06-02T06:00:00Z"), 1}};
  const auto flights = twin::fly(scenario, surround_of(scenario), cases, {});
  for (const twin::Flight& flight : flights) {
    ASSERT_TRUE(flight.noise);
    EXPECT_EQ(flight.noise->by, "worker");
    EXPECT_TRUE(flight.is_done) << flight.stopped_by;
    // 40 m at 1 m/s from a standstill.
    EXPECT_NEAR(flight.noise->noise_s, 40, 10);
  }
  const auto alone = twin::fly(scenario, surround_of(scenario), {&cases[1], 1}, {});
  EXPECT_EQ(alone[0].noise->noise_s, flights[1].noise->noise_s);
  EXPECT_EQ(alone[0].ended_s, flights[1].ended_s);
}

TEST(NoisyWorkInARun, RefusesATieToNobody) {
  const auto message = [](const std::string& vehicles) {
    try {
      (void)ready_of(head_of_run + vehicles);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_NE(message(worker + watch(", noise_by: piler")).find("found piler, expected another"),
            std::string::npos);
  EXPECT_NE(message(worker + watch(", noise_by: watch")).find("work to do: worker"),
            std::string::npos);
  EXPECT_NE(message(watch()).find("of which there is none"), std::string::npos);
  std::string second = watch("");
  second.replace(second.find("name: watch"), 11, "name: other");
  EXPECT_NE(message(worker + watch() + second).find("or at neither"), std::string::npos);
  std::string blind = watch();
  blind.replace(blind.find("mammals: {"), blind.find("}}, noise_by") + 4 - blind.find("mammals: {"),
                "");
  EXPECT_NE(message(worker + blind).find("found without mammals"), std::string::npos) << blind;
}

}  // namespace
}  // namespace slackwater::tests::noisy_work_in_a_run_test
