#include "twin/rehearse/flight.h"

#include <gtest/gtest.h>

#include "fields/base/text.h"
#include "tests/twin/run/run_for_tests.h"
#include "twin/state/milestones.h"

namespace slackwater::tests::flight_test {
namespace {

UtcTime first_start() { return parse_utc("2025-06-02T06:00:00Z"); }

/// An ROV that swims 20 m into a current that has set in an hour later.
twin::Scenario against_the_current() {
  return twin::parse_scenario(
      "name: test\nseed: 3\nduration: 4min\nstep_s: 0.05\nlog_every_s: 1\n"
      "water: {made_up: {depth_m: 40, current: [{depth_m: 0, east_m_s: 0, north_m_s: 0}], "
      "wind: {speed_m_s: 0, from_deg: 0}}}\nwaves: {from: calm}\nvehicles:\n"
      "  - {name: rov, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: 10}, "
      "speed_m_s: 0.4, conduct: {limits: [{current_speed_m_s: 0.6}]}, tasks: [{do: route, phase: "
      "work, waypoints: [{north_m: 0, east_m: 20, depth_m: 10}]}]}\n",
      "test.yaml");
}

twin::Surround rising_current(const twin::Scenario& mission) {
  std::vector<UtcTime> times;
  std::vector<Horizontal> current;
  for (int hour = 0; hour <= 3; ++hour) {
    times.push_back(first_start() + std::chrono::hours(hour));
    const double west_m_s = hour == 0 ? 0 : 0.8;
    for (int level = 0; level < 2; ++level) current.emplace_back(-west_m_s, 0);
  }
  twin::Surround surround = surround_of(mission);
  surround.field = twin::made_up_field(times, {0, 40}, current, {0, 0}, surround.site, 40);
  return surround;
}

TEST(Flight, IsOverForItselfWhileOthersLast) {
  const twin::Scenario mission = against_the_current();
  const twin::Surround surround = rising_current(mission);
  const std::vector<twin::FlightCase> both{{first_start(), 0},
                                           {first_start() + std::chrono::hours(1), 0}};
  const std::vector<twin::Flight> together = twin::fly(mission, surround, both, {});
  ASSERT_TRUE(together[0].is_done) << together[0].stopped_by;
  ASSERT_FALSE(together[1].is_done);
  ASSERT_LT(together[0].ended_s + 60, together[1].ended_s);
  const twin::Flight alone = twin::fly(mission, surround, {both.data(), 1}, {}).front();
  const twin::VehicleAccount &a = together[0].vehicles[0], &b = alone.vehicles[0];
  EXPECT_EQ(a.on_mission.drawn_j, b.on_mission.drawn_j);
  EXPECT_EQ(a.on_mission.charge, b.on_mission.charge);
  EXPECT_EQ(a.least_charge, b.least_charge);
  EXPECT_EQ(together[0].ended_s, alone.ended_s);
  // What stood still meanwhile is where it was.
  const twin::FlightSample &early = alone.samples[0].back(), &late = together[0].samples[0].back();
  EXPECT_NEAR(late.east_m, early.east_m, 1);
  EXPECT_NEAR(late.charge, early.charge, 1e-3);
}

/// The outcome of the flight above, over after 100 s, with something befallen it.
template <typename Change>
twin::VehicleAccount outcome_with(Change&& change) {
  const twin::Scenario mission = against_the_current();
  twin::ReadyRun ready = twin::set_up(mission, surround_of(mission));
  twin::AgentState& state = ready.states[0];
  state.conduct.has_ended = true;
  state.mission.is_done = true;
  state.conduct.events.push_back({100, twin::ConductEventKind::finished});
  change(state);
  return twin::account_of({ready.agents, ready.states, mission.structures, 240}, 0);
}

TEST(VehicleAccount, NamesWhatBefellAVehicle) {
  using twin::AgentState;
  using twin::RiskCause;
  const auto one = [](RiskCause cause) {
    twin::RiskCauses causes;
    causes.add(cause);
    return causes;
  };
  const auto risks = [](auto&& change) { return outcome_with(change).risks(); };
  EXPECT_TRUE(risks([](AgentState&) {}).none());
  EXPECT_TRUE(outcome_with([](AgentState&) {}).is_done);
  EXPECT_EQ(risks([](AgentState& s) { s.conduct.most_share = 1.1; }), one(RiskCause::limit));
  EXPECT_EQ(risks([](AgentState& s) { s.milestones.power_lost_s = 50; }), one(RiskCause::energy));
  EXPECT_EQ(risks([](AgentState& s) { s.conduct.at_end.charge = 0.01; }), one(RiskCause::energy));
  EXPECT_EQ(risks([](AgentState& s) { s.halt = twin::Halt::no_headway; }), one(RiskCause::station));
  EXPECT_EQ(risks([](AgentState& s) { s.halt = twin::Halt::struck; }), one(RiskCause::collision));
  EXPECT_EQ(risks([](AgentState& s) { s.mission.is_done = false; }), one(RiskCause::work));
  // After the end it is no part of the mission.
  EXPECT_TRUE(risks([](AgentState& s) { s.milestones.line_parted_s = 120; }).none());
  const twin::VehicleAccount parted =
      outcome_with([](AgentState& s) { s.milestones.line_parted_s = 60; });
  EXPECT_EQ(parted.risks(), one(RiskCause::tether));
  EXPECT_FALSE(parted.is_done);
  EXPECT_EQ(parted.stopped_by, "its tether parted");
  EXPECT_EQ(twin::time_of(parted.fate, twin::Fate::tether_parted), 60.0);
}

TEST(VehicleAccount, HasLessThrustToSpareInMoreCurrent) {
  const auto used = [](double current_m_s) {
    twin::Scenario mission = against_the_current();
    twin::Surround surround = surround_of(mission);
    const std::vector<Horizontal> current(4, Horizontal(-current_m_s, 0));
    surround.field = twin::made_up_field({first_start(), first_start() + std::chrono::hours(1)},
                                         {0, 40}, current, {0, 0}, surround.site, 40);
    const std::vector<twin::FlightCase> once{{first_start(), 0}};
    return twin::fly(mission, surround, once, {}).front().vehicles[0].thrust_used;
  };
  const double calm = used(0), tide = used(0.5);
  EXPECT_GT(calm, 0);
  // Drag goes with the square of 0.4 and of 0.9 m/s through the water, or nearly.
  EXPECT_GT(tide, 3 * calm);
  EXPECT_LT(tide, 1);
}

TEST(Milestones, HaveTheHardestPullAndTheFirstPartingOfALine) {
  twin::Milestones m;
  twin::note_line(m, 1, 40, 1);
  twin::note_line(m, 1, 20, 2);
  EXPECT_EQ(m.most_line_n, 40);
  EXPECT_TRUE(std::isnan(m.line_parted_s));
  twin::note_line(m, 0, 0, 3);
  twin::note_line(m, 0, 0, 4);
  EXPECT_EQ(m.line_parted_s, 3);
}

}  // namespace
}  // namespace slackwater::tests::flight_test
