// Flights and limits have the same waves: those of the forecast with the error of their member.
#include "tests/twin/run/sea_for_tests.h"
#include "twin/agent/conduct.h"
#include "twin/rehearse/flight.h"
#include "twin/rehearse/limit_ahead.h"

namespace slackwater::tests::waves_of_flights_test {
namespace {

/// An ROV that goes some way at half a metre a second, for as long as waves are 1.5 m at most, and
/// comes home.
twin::Scenario on_a_line(double way_m, const std::string& duration, bool errs) {
  const std::string line = std::to_string(way_m);
  return with_forecast_waves(
      "name: test\nseed: 3\nduration: " + duration +
          "\nstep_s: 0.05\nlog_every_s: 1\nwater: {made_up: {depth_m: 40}}\nwaves: {from: calm, "
          "components: 8}\nvehicles:\n"
          "  - {name: rov, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: 20}, "
          "speed_m_s: 0.5, conduct: {limits: [{significant_wave_height_m: 1.5, phases: [work]}]}, "
          "tasks: [{do: route, phase: work, waypoints: [{north_m: " +
          line + ", east_m: 0, depth_m: 20}, {north_m: 0, east_m: 0, depth_m: 20}]}]}\n",
      errs);
}

TEST(WavesOfFlights, ASeaThatRisesPastTheLimitHoldsTheWorkAndSendsItHome) {
  const twin::Scenario mission = on_a_line(300, "55min", false);
  // 1.5 m after six minutes, in the middle of the way.
  const twin::Surround surround = in_forecast_sea(mission, {{1, 6, 250}, {6, 9, 250}});
  const twin::FlightCase flown{sea_start(), 0};
  const twin::Flight flight = twin::fly(mission, surround, {&flown, 1}, {}).front();
  EXPECT_FALSE(flight.is_done);
  std::vector<twin::MissionEvent> told;
  for (const twin::MissionEvent& event : flight.vehicles[0].mission)
    if (event.kind != twin::ConductEventKind::phase_began) told.push_back(event);
  ASSERT_GE(told.size(), 3U);
  EXPECT_EQ(told[0].kind, twin::ConductEventKind::hold_began);
  EXPECT_EQ(told[0].cause, twin::Cause::limit);
  EXPECT_NEAR(told[0].t_s, 360, 3);
  EXPECT_NEAR(told[0].value.value_or(0), 1.5, 0.005);
  EXPECT_EQ(told[1].kind, twin::ConductEventKind::turned_for_home);
  EXPECT_NEAR(told[1].t_s, 360 + 1800, 10);
  EXPECT_EQ(told[2].kind, twin::ConductEventKind::came_home);
  // The waves that the flight tells of are those of the limit.
  const auto& samples = flight.samples[0];
  EXPECT_NEAR(samples[10].wave_height_m, 1 + 5 * 600.0 / 3600, 1e-3);
}

/// A flight is stopped in just those members in which the limits ahead are broken while it lasts:
/// nothing else stops it.
TEST(WavesOfFlights, AreStoppedInTheMembersInWhichTheLimitsAheadBreak) {
  constexpr std::size_t members = 10;
  const std::vector<SeaState> hourly{{1.3, 6, 250}, {1.4, 6, 250}};
  const twin::Scenario mission = on_a_line(30, "10min", true);
  const twin::Surround surround = in_forecast_sea(mission, hourly, members);
  const twin::WaveFutures futures(surround.field->snapshot(), members);
  twin::Scenario central = mission;
  central.start = sea_start();
  const twin::ReadyRun ready = twin::set_up(central, surround);
  const StepClock clock{sea_start(), std::chrono::minutes(1), 3};
  const std::vector<twin::LimitAhead> ahead =
      twin::limits_ahead(ready, 0, clock, members, &futures);
  ASSERT_EQ(ahead.size(), 1U);
  // Worked out from a run that has errors of its own: they are not counted twice.
  twin::Scenario other = central;
  other.member = 3;
  EXPECT_EQ(
      twin::limits_ahead(twin::set_up(other, surround), 0, clock, members, &futures)[0].members,
      ahead[0].members);
  std::vector<twin::FlightCase> cases;
  std::vector<bool> holds;
  std::size_t stopped = 0;
  for (std::size_t m = 0; m < members; ++m) {
    const std::vector<double>& values = ahead[0].members[m];
    const double most_m = *std::max_element(values.begin(), values.end());
    const double least_m = *std::min_element(values.begin(), values.end());
    // It is clear what the limit says of the flight, 2 minutes long.
    ASSERT_TRUE(most_m < 1.5 || least_m > 1.5) << "member " << m << ": choose another height";
    holds.push_back(most_m < 1.5);
    stopped += most_m < 1.5 ? 0 : 1;
    cases.push_back({sea_start(), m});
  }
  EXPECT_GE(stopped, 1U);
  EXPECT_LE(stopped, members - 2);
  const std::vector<twin::Flight> flights = twin::fly(mission, surround, cases, {});
  for (std::size_t m = 0; m < members; ++m) {
    EXPECT_EQ(flights[m].is_done, holds[m]) << "member " << m << ": " << flights[m].stopped_by;
    // Side by side as by itself.
    const twin::Flight alone = twin::fly(mission, surround, {&cases[m], 1}, {}).front();
    EXPECT_EQ(alone.vehicles[0].on_mission.drawn_j, flights[m].vehicles[0].on_mission.drawn_j);
  }
  // With the waves of the forecast no member is stopped.
  const std::vector<twin::Flight> as_forecast =
      twin::fly(on_a_line(30, "10min", false), surround, cases, {});
  for (const twin::Flight& flight : as_forecast) EXPECT_TRUE(flight.is_done) << flight.stopped_by;
}

/// In higher waves it takes more to stay on the way, whatever else is the same.
TEST(WavesOfFlights, MoveTheVehicleToo) {
  twin::Scenario mission = on_a_line(30, "10min", false);
  mission.vehicles[0].start_m.z = 4;
  for (auto& waypoint : mission.vehicles[0].tasks[0].waypoints) waypoint.position_m.z = 4;
  const twin::FlightCase flown{sea_start(), 0};
  const auto energy_j = [&](double then_m) {
    // 1 m at the start in both.
    const twin::Surround surround = in_forecast_sea(mission, {{1, 6, 250}, {then_m, 6, 250}});
    const twin::Flight flight = twin::fly(mission, surround, {&flown, 1}, {}).front();
    EXPECT_TRUE(flight.is_done) << flight.stopped_by;
    return flight.vehicles[0].on_mission.drawn_j;
  };
  EXPECT_GT(energy_j(2.5), 1.005 * energy_j(0));
}

}  // namespace
}  // namespace slackwater::tests::waves_of_flights_test
