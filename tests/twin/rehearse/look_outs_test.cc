#include <gtest/gtest.h>

#include <memory>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "tests/twin/run/run_for_tests.h"
#include "twin/rehearse/flight.h"

namespace slackwater::tests::look_outs_test {
namespace {

/// A boat that sweeps an area and a vessel that lies far off, a current of 0.3 m/s eastwards and
/// wind from the west.
std::string boat_and_vessel(const std::string& sweeper, const std::string& bystander,
                            double wind_m_s = 5) {
  return formatted(
      "name: test\nseed: 3\nduration: 10min\nstep_s: 0.1\nlog_every_s: 1\n"
      "water: {{made_up: {{depth_m: 40, current: [{{depth_m: 0, east_m_s: 0.3, north_m_s: 0}}], "
      "wind: {{speed_m_s: {}, from_deg: 270}}}}}}\nwaves: {{from: calm}}\nvehicles:\n"
      "  - {{name: sweeper, model: wamv16, start: {{north_m: 0, east_m: 0, depth_m: 0}}, "
      "speed_m_s: "
      "2, conduct: {{{}}}, tasks: [{{do: route, phase: work, waypoints: [{{north_m: 60, east_m: "
      "60, depth_m: 0}}, {{north_m: 260, east_m: 60, depth_m: 0}}, {{north_m: 260, east_m: 140, "
      "depth_m: 0}}, {{north_m: 60, east_m: 140, depth_m: 0}}]}}]}}\n"
      "  - {{name: bystander, model: ctv24, start: {{north_m: -900, east_m: 0, depth_m: 0}}, "
      "conduct: {{{}}}, tasks: [{{do: hold, duration: 1min}}]}}\n",
      wind_m_s, sweeper, bystander);
}

std::string search_by(const std::string& lookout, const std::string& object, double visibility_m,
                      const std::string& more = "") {
  return formatted(
      "search: {{object: {}, lookout: {}, radius_m: 20, elapsed: 1min, visibility_m: {}, "
      "last_known: {{north_m: 150, east_m: 80}}{}}}",
      object, lookout, visibility_m, more);
}

twin::Flight flown(const std::string& yaml) {
  const twin::Scenario scenario = twin::parse_scenario(yaml, "test.yaml");
  const twin::FlightCase flown{parse_utc("2025-06-02T06:00:00Z"), 0};
  return twin::fly(scenario, surround_of(scenario), {&flown, 1}, {}).front();
}

TEST(SearchInAFlight, FindsWhomItSweepsOver) {
  const twin::Flight flight =
      flown(boat_and_vessel(search_by("small_boat", "person_upright", 1e4), ""));
  EXPECT_TRUE(flight.is_done) << flight.stopped_by;
  ASSERT_TRUE(flight.found_s);
  EXPECT_GT(*flight.found_s, 0);
  EXPECT_LT(*flight.found_s, 300);
  int told = 0;
  for (const twin::MissionEvent& event : flight.vehicles[0].mission) {
    if (event.kind != twin::ConductEventKind::found) continue;
    ++told;
    EXPECT_EQ(event.t_s, *flight.found_s);
    EXPECT_GT(event.value.value_or(0), 0);
  }
  EXPECT_EQ(told, 1);
}

TEST(SearchInAFlight, IsNotDoneInAFogThatHidesHim) {
  const twin::Flight flight =
      flown(boat_and_vessel(search_by("small_boat", "person_upright", 5), ""));
  EXPECT_FALSE(flight.is_done);
  EXPECT_EQ(flight.stopped_by, "not found");
  EXPECT_FALSE(flight.found_s);
  // Each vehicle did what it was asked to.
  EXPECT_TRUE(flight.vehicles[0].is_done) << flight.vehicles[0].stopped_by;
}

TEST(SearchInAFlight, IsDoneByWhoeverFindsHim) {
  const twin::Flight flight =
      flown(boat_and_vessel(search_by("small_boat", "person_upright", 1e4),
                            search_by("drone_camera", "person_upright", 1e4)));
  EXPECT_TRUE(flight.is_done) << flight.stopped_by;
  EXPECT_TRUE(flight.vehicles[0].found_s);
  EXPECT_FALSE(flight.vehicles[1].found_s);
}

TEST(SearchInAFlight, SaysWhatThereIsToSearchFor) {
  try {
    (void)flown(boat_and_vessel(search_by("small_boat", "person_asleep", 1e4), ""));
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("person_face_down"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("sweeper"), std::string::npos);
  }
}

TEST(SearchInARun, LetsABuoyDriftWithTheCurrentAlone) {
  const std::string at =
      "search: {object: drift_buoy, lookout: small_boat, radius_m: 0, elapsed_s: 100, "
      "visibility_m: "
      "10, last_known: {north_m: 150, east_m: 80}}";
  twin::ReadyRun ready = ready_of(boat_and_vessel(at, ""));
  twin::RunSettings settings;
  settings.step_s = 0.1;
  twin::Run run(std::move(ready.agents), std::move(ready.states), settings);
  while (run.time_s() < 60.05) run.step();
  const twin::Triple<double> at_m = run.states()[0].conduct.search.person.position_m;
  EXPECT_NEAR(at_m.x, 150, 1e-9);
  // A hundred seconds before the start and sixty since.
  EXPECT_NEAR(at_m.y, 80 + 0.3 * 160, 0.05);
}

TEST(SearchInARun, HasOnePersonForAllWhoSearch) {
  twin::ReadyRun ready =
      ready_of(boat_and_vessel(search_by("small_boat", "person_unknown", 1e4),
                               search_by("drone_camera", "person_unknown", 1e4)));
  twin::RunSettings settings;
  settings.step_s = 0.1;
  twin::Run run(std::move(ready.agents), std::move(ready.states), settings);
  while (run.time_s() < 50) run.step();
  const auto states = run.states();
  const auto& a = states[0].conduct.search.person.position_m;
  const auto& b = states[1].conduct.search.person.position_m;
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.y, b.y);
  EXPECT_GT(a.y, 80);
}

TEST(SearchInARun, GoesOnFromACheckpointAsItWould) {
  const std::string yaml = boat_and_vessel(
      search_by("small_boat", "person_unknown", 50, ", diffusivity_m2_s: 0.5"),
      "mammals: {animal: harbour_porpoise, watch: observer, count: 5, half_side_m: 500, radius_m: "
      "300, clear_for: 1min, noise_for: 1min}");
  const auto fresh = [&] {
    twin::ReadyRun ready = ready_of(yaml);
    twin::RunSettings settings;
    settings.step_s = 0.1;
    return std::make_unique<twin::Run>(std::move(ready.agents), std::move(ready.states), settings);
  };
  const auto whole = fresh(), first = fresh(), second = fresh();
  while (whole->time_s() < 50) whole->step();
  while (first->time_s() < 20) first->step();
  second->restore(first->checkpoint());
  while (second->time_s() < 50) second->step();
  const auto a = whole->states(), b = second->states();
  EXPECT_EQ(a[0].conduct.search.person.position_m.x, b[0].conduct.search.person.position_m.x);
  EXPECT_EQ(a[0].conduct.search.found_s, b[0].conduct.search.found_s);
  EXPECT_EQ(a[1].conduct.mammals.sightings_s, b[1].conduct.mammals.sightings_s);
  EXPECT_EQ(a[1].conduct.mammals.mammals.animals[2].position_m.x,
            b[1].conduct.mammals.mammals.animals[2].position_m.x);
}

std::string mammals_by(const std::string& watch, int count, const std::string& clear_for,
                       const std::string& noise_for) {
  return formatted(
      "mammals: {{animal: harbour_porpoise, watch: {}, count: {}, half_side_m: 1000, radius_m: "
      "300, "
      "clear_for: {}, noise_for: {}, noise: {{north_m: 100, east_m: 100}}}}",
      watch, count, clear_for, noise_for);
}

TEST(MammalsInAFlight, LetTheWorkBeDoneWhereThereAreNone) {
  const twin::Flight flight = flown(boat_and_vessel(mammals_by("observer", 0, "1min", "2min"), ""));
  EXPECT_TRUE(flight.is_done) << flight.stopped_by;
  ASSERT_TRUE(flight.noise);
  EXPECT_NEAR(flight.noise->noise_s, 120, 1e-9);
  EXPECT_EQ(flight.noise->stops, 0);
  EXPECT_NEAR(flight.noise->noisy_s.front(), 60, 1.5);
}

TEST(MammalsInAFlight, KeepTheWorkFromBeingDoneWhereThereAreMany) {
  const twin::Flight flight =
      flown(boat_and_vessel(mammals_by("observer", 300, "1min", "2min"), ""));
  EXPECT_FALSE(flight.is_done);
  EXPECT_EQ(flight.stopped_by, "marine mammals within the radius");
}

TEST(MammalsInAFlight, AreExposedWhereNobodySeesThem) {
  // In a storm the watch is blind: it lets the noise begin.
  const twin::Flight blind =
      flown(boat_and_vessel(mammals_by("observer", 300, "1min", "2min"), "", 18));
  ASSERT_TRUE(blind.noise);
  EXPECT_EQ(blind.noise->stops, 0);
  EXPECT_GT(blind.noise->exposed_s, 0.9 * blind.noise->noise_s);
}

TEST(MammalsInAFlight, AreWatchedForNoLongerThanTheWatchIsOut) {
  const twin::Flight flight =
      flown(boat_and_vessel(mammals_by("observer", 0, "30min", "2min"), ""));
  EXPECT_FALSE(flight.is_done);
  EXPECT_EQ(flight.stopped_by, "the watch for marine mammals was too short");
}

}  // namespace
}  // namespace slackwater::tests::look_outs_test
