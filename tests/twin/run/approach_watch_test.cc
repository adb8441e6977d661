#include "twin/run/approach_watch.h"

#include "tests/twin/run/run_for_tests.h"
#include "twin/agent/hung_line.h"

// How near the vehicles of a run came to what was around them: against straight ways whose closest
// approach is known, against all of all, and against what the log of a run says.

namespace slackwater::twin::approach_watch_test {
namespace {

constexpr double barrier_s = 0.1;

std::string rov(const std::string& name, const std::string& more = "") {
  return "  - {name: " + name +
         ", model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: 10}" + more + "}\n";
}
constexpr const char* on_a_line =
    ", tether: {top: {north_m: 0, east_m: 0, depth_m: 1}, length_m: 40}";

/// Vehicles that are led along straight lines by hand.
struct Led {
  ReadyRun ready;
  ApproachWatch watch;
  std::vector<Triple<double>> start_m;
  std::vector<Triple<double>> velocity_m_s;
  double t_s = 0;

  explicit Led(const std::string& yaml) : ready(tests::ready_of(yaml)), watch(ready.agents) {
    start_m.resize(ready.agents.size(), {0, 0, 10});
    velocity_m_s.resize(ready.agents.size());
  }
  void begin() {
    lead(0);
    watch.begin(ready.states, 0);
    watch.look(ready.agents, ready.states, 0);
  }
  void lead(double to_s) {
    t_s = to_s;
    for (std::size_t i = 0; i < ready.states.size(); ++i)
      ready.states[i].vehicle.body.position_m = start_m[i] + t_s * velocity_m_s[i];
  }
  /// Barriers until then.
  void go_on(double end_s) {
    const auto first = static_cast<int>(std::lround(t_s / barrier_s));
    const auto last = static_cast<int>(std::lround(end_s / barrier_s));
    for (int i = first + 1; i <= last; ++i) {
      lead(i * barrier_s);
      watch.look(ready.agents, ready.states, t_s);
    }
  }
  const NearestPasses& of(std::size_t i) const { return ready.states[i].nearest; }
};

TEST(ApproachWatch, TwoOnCrossingLinesCameAsNearAsTheClosedFormSaysAndThen) {
  Led led(tests::calm_head(barrier_s) + rov("a") + rov("b"));
  led.start_m = {{-50, 3, 10}, {2, -70, 12}};
  led.velocity_m_s = {{1.3, 0, 0.01}, {0.2, 2.1, 0}};
  const Triple<double> apart = led.start_m[1] - led.start_m[0];
  const Triple<double> closing = led.velocity_m_s[1] - led.velocity_m_s[0];
  const double at_s = -dot(apart, closing) / dot(closing, closing);
  const double least_m = length_of(apart + at_s * closing);
  ASSERT_GT(std::abs(std::remainder(at_s, barrier_s)), 0.01) << "between two barriers";
  led.begin();
  led.go_on(60);
  for (const std::size_t i : {0U, 1U}) {
    EXPECT_NEAR(led.of(i).vehicle.distance_m, least_m, 1e-9);
    EXPECT_NEAR(led.of(i).vehicle.t_s, at_s, 1e-7);
    EXPECT_EQ(led.of(i).vehicle.whom, 1.0 - static_cast<double>(i));
    EXPECT_FALSE(led.of(i).structure.is_any());
    EXPECT_FALSE(led.of(i).vessel.is_any());
    EXPECT_FALSE(led.of(i).line.is_any());
  }
}

TEST(ApproachWatch, OnePassesACylinderAtTheDistanceOfItsLineLessTheRadius) {
  Led led(tests::calm_head(barrier_s) + rov("a") +
          "structures:\n"
          "  - {kind: cylinder, north_m: 500, east_m: 0, diameter_m: 6, top_height_m: 10, "
          "bottom_depth_m: 60}\n"
          "  - {kind: cylinder, north_m: 20, east_m: 30, diameter_m: 6, top_height_m: 10, "
          "bottom_depth_m: 60}\n");
  // A line square to (3, 4)/5, 7 m from the axis of the second.
  led.velocity_m_s[0] = {1.6, -1.2, 0};
  led.start_m[0] =
      Triple<double>{20, 30, 10} + 7.0 * Triple<double>{0.6, 0.8, 0} - 15.03 * led.velocity_m_s[0];
  led.begin();
  led.go_on(40);
  EXPECT_NEAR(led.of(0).structure.distance_m, 7 - 3, 1e-9);
  EXPECT_NEAR(led.of(0).structure.t_s, 15.03, barrier_s) << "by whole barriers";
  EXPECT_EQ(led.of(0).structure.whom, 1);
  EXPECT_FALSE(led.of(0).vehicle.is_any()) << "it is alone";
}

TEST(ApproachWatch, AVesselPassesInThePlaneWhereItIsHeard) {
  Led led(tests::calm_head(barrier_s) + rov("a") +
          "traffic: {vessels: [{mmsi: 7, name: FERRY, speed_m_s: 10, begins_s: 20, waypoints: "
          "[{north_m: 300, east_m: 80}, {north_m: -300, east_m: 80}]}]}\n");
  led.start_m[0] = {0, 0, 25};
  led.velocity_m_s[0] = {0, 0.5, 0};
  led.begin();
  led.go_on(15);
  EXPECT_FALSE(led.of(0).vessel.is_any()) << "it is not there yet";
  led.go_on(75);
  // Between them: (300 - 10 (t - 20), 80 - 0.5 t) in the plane.
  const double at_s = (10 * 500 + 0.5 * 80) / (100 + 0.25);
  EXPECT_NEAR(led.of(0).vessel.distance_m, std::hypot(500 - 10 * at_s, 80 - 0.5 * at_s), 1e-6);
  EXPECT_NEAR(led.of(0).vessel.t_s, at_s, 1e-5);
  EXPECT_EQ(led.of(0).vessel.whom, 7);
}

/// A line that hangs straight down beside (north, east).
void hang(const Agent& agent, const Triple<double>& top_m, AgentState& state) {
  const Triple<double> end_m = hung_line(agent, state).back();
  for (std::size_t k = 0; k < state.tether.node_m.size(); ++k)
    state.tether.node_m[k] = top_m + (double(k + 1) / tether_segments) *
                                         (Triple<double>{top_m.x, top_m.y, end_m.z} - top_m);
}

TEST(ApproachWatch, AnothersTetherIsPassedAndCrossedButNobodysOwn) {
  const std::string yaml = tests::calm_head(barrier_s) + rov("a") + rov("b", on_a_line);
  Led led(yaml);
  led.start_m = {{-30, 5, 8}, {0, 0, 40}};
  led.velocity_m_s[0] = {1, 0, 0};
  led.lead(0);
  hang(led.ready.agents[1], {0, 0, 1}, led.ready.states[1]);
  led.begin();
  led.go_on(60);
  EXPECT_NEAR(led.of(0).line.distance_m, 5, 1e-9);
  EXPECT_NEAR(led.of(0).line.t_s, 30, 1e-7);
  EXPECT_EQ(led.of(0).line.whom, 1);
  EXPECT_FALSE(led.of(1).line.is_any());
  EXPECT_NEAR(led.of(0).vehicle.distance_m, std::hypot(5.0, 32.0), 1e-9) << "its vehicle is deep";
  // Across it, faster than from one barrier to the next would show.
  Led crossing(yaml);
  crossing.start_m = {{-29.7, 0, 8}, {0, 0, 40}};
  crossing.velocity_m_s[0] = {9, 0, 0};
  crossing.lead(0);
  hang(crossing.ready.agents[1], {0, 0, 1}, crossing.ready.states[1]);
  crossing.begin();
  crossing.go_on(6);
  EXPECT_NEAR(crossing.of(0).line.distance_m, 0, 1e-9);
  EXPECT_NEAR(crossing.of(0).line.t_s, 3.3, 1e-7);
  // One that parted is in nobody's way.
  Led parted(yaml);
  parted.start_m = led.start_m;
  parted.velocity_m_s = led.velocity_m_s;
  parted.ready.states[1].tether.whole = 0;
  parted.begin();
  parted.go_on(60);
  EXPECT_FALSE(parted.of(0).line.is_any());
}

/// Two that run through each other, but for what was done to them.
template <typename Change>
Led met_but_for(const Change& change) {
  Led led(tests::calm_head(barrier_s) + rov("a") + rov("b"));
  led.start_m = {{-10, 0, 10}, {10, 1, 10}};
  led.velocity_m_s = {{1, 0, 0}, {-1, 0, 0}};
  change(led);
  led.begin();
  led.go_on(20);
  return led;
}

TEST(ApproachWatch, WhoIsAboardOrBelongsTogetherOrLivesInAnotherFutureIsNotMet) {
  const Led met = met_but_for([](Led&) {});
  EXPECT_NEAR(met.of(0).vehicle.distance_m, 1, 1e-12);
  const Led aboard = met_but_for([](Led& led) { led.ready.states[1].conduct.is_aboard = true; });
  EXPECT_FALSE(aboard.of(0).vehicle.is_any());
  EXPECT_FALSE(aboard.of(1).vehicle.is_any());
  const Led carried = met_but_for([](Led& led) { led.ready.agents[1].carrier = 0; });
  EXPECT_FALSE(carried.of(0).vehicle.is_any());
  EXPECT_FALSE(carried.of(1).vehicle.is_any());
  const Led apart = met_but_for([](Led& led) {
    const ReadyRun other = tests::ready_of(tests::calm_head(barrier_s) + rov("b"));
    led.ready.agents[1].water = other.agents[0].water;
    led.watch = ApproachWatch(led.ready.agents);
  });
  EXPECT_FALSE(apart.of(0).vehicle.is_any());
}

TEST(ApproachWatch, WhoHasHaltedIsThereForTheOthersAndMeetsNobodyItself) {
  const Led halted = met_but_for([](Led& led) {
    led.ready.states[1].halt = Halt::struck;
    led.ready.states[1].halted_at_s = 0;
    led.velocity_m_s[1] = {};
    led.start_m[1] = {0, 2, 10};
  });
  EXPECT_NEAR(halted.of(0).vehicle.distance_m, 2, 1e-12);
  EXPECT_FALSE(halted.of(1).vehicle.is_any());
}

TEST(ApproachWatch, WhoIsPutElsewhereDidNotGoThere) {
  Led led(tests::calm_head(barrier_s) + rov("a") + rov("b"));
  led.start_m = {{-10, 0, 10}, {0, 0, 10}};
  led.begin();
  led.go_on(1);
  // Through the other, had it gone.
  led.start_m[0] = {30, 0, 10};
  led.lead(1);
  led.watch.put(0, led.ready.states[0]);
  led.go_on(2);
  EXPECT_EQ(led.of(0).vehicle.distance_m, 10);
  EXPECT_EQ(led.of(1).vehicle.distance_m, 10);
  EXPECT_EQ(led.of(1).vehicle.t_s, 0);
}

TEST(ApproachWatch, WhereThereIsNoPlaceNothingIsMet) {
  Led led(tests::calm_head(barrier_s) + rov("a") + rov("b") + rov("c"));
  led.start_m = {{-10, 0, 10}, {std::nan(""), 0, 10}, {0, 0, 10}};
  led.begin();
  led.go_on(1);
  EXPECT_EQ(led.of(0).vehicle, (NearestPass{10, 0, 2}));
  EXPECT_FALSE(led.of(1).vehicle.is_any());
}

TEST(ApproachWatch, WhatItLeavesOutIsNeverTheNearest) {
  // Forty on random ways among structures and lines: all with all, at every barrier.
  std::string yaml = tests::calm_head(barrier_s);
  constexpr std::size_t count = 40;
  for (std::size_t i = 0; i < count; ++i)
    yaml += rov("v" + std::to_string(i), i % 8 == 0 ? on_a_line : "");
  yaml += "structures:\n";
  for (int i = 0; i < 6; ++i)
    yaml += "  - {kind: cylinder, north_m: " + std::to_string(40 * i - 100) +
            ", east_m: " + std::to_string(17 * i - 50) +
            ", diameter_m: 6, top_height_m: 10, bottom_depth_m: 60}\n";
  Led led(yaml);
  Rng rng(7, "tests/approach_watch");
  for (std::size_t i = 0; i < count; ++i) {
    led.start_m[i] = {rng.uniform(-150, 150), rng.uniform(-80, 80), rng.uniform(5, 30)};
    led.velocity_m_s[i] = {rng.uniform(-4, 4), rng.uniform(-4, 4), 0};
  }
  led.begin();
  std::vector<NearestPasses> expected(count);
  const auto& structures = led.ready.agents[0].water->environment().structures;
  const auto look_at_all = [&](const std::vector<Triple<double>>& before) {
    const auto& states = led.ready.states;
    const auto at = [&](std::size_t i) { return states[i].vehicle.body.position_m; };
    for (std::size_t i = 0; i < count; ++i) {
      NearestPasses& own = expected[i];
      for (std::size_t j = 0; j < count; ++j) {
        if (j == i) continue;
        const LeastOnWay least = least_between(before[j] - before[i], at(j) - at(i));
        own.vehicle.take(least.distance_m, 0, static_cast<double>(j));
        if (!led.ready.agents[j].tether) continue;
        const auto nodes = hung_line(led.ready.agents[j], states[j]);
        for (std::size_t k = 1; k < nodes.size(); ++k)
          own.line.take(least_to_piece(before[i], at(i), nodes[k - 1], nodes[k]).distance_m, 0,
                        static_cast<double>(j));
      }
      for (std::size_t s = 0; s < structures.size(); ++s)
        own.structure.take(least_distance_m(structures[s], before[i], at(i)), 0,
                           static_cast<double>(s));
    }
  };
  std::vector<Triple<double>> before = led.start_m;
  look_at_all(before);
  for (int step = 1; step <= 300; ++step) {
    led.go_on(step * barrier_s);
    look_at_all(before);
    for (std::size_t i = 0; i < count; ++i) before[i] = led.ready.states[i].vehicle.body.position_m;
  }
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_EQ(led.of(i).vehicle.distance_m, expected[i].vehicle.distance_m) << i;
    EXPECT_EQ(led.of(i).vehicle.whom, expected[i].vehicle.whom) << i;
    EXPECT_EQ(led.of(i).structure.distance_m, expected[i].structure.distance_m) << i;
    EXPECT_EQ(led.of(i).structure.whom, expected[i].structure.whom) << i;
    EXPECT_EQ(led.of(i).line.distance_m, expected[i].line.distance_m) << i;
  }
}

/// Vehicles of all kinds that come past each other, a pile and a ferry, one on a tether.
std::string passing_each_other() {
  return tests::head(0.1, "{from: calm}", "dryden") +
         "  - {name: a, model: bluerov2_heavy, start: {north_m: -8, east_m: 0, depth_m: 10}, "
         "tasks: [{do: route, waypoints: [{north_m: 9, east_m: 1, depth_m: 12}]}]}\n"
         "  - {name: b, model: bluerov2_heavy, start: {north_m: 8, east_m: 1, depth_m: 11, "
         "heading_deg: 180}, tasks: [{do: route, waypoints: [{north_m: -9, east_m: 3, depth_m: "
         "11}]}], tether: {top: {north_m: 9, east_m: 4, depth_m: 1}, length_m: 40}}\n"
         "  - {name: usv, model: wamv16, start: {north_m: 0, east_m: -30, depth_m: 0, heading_deg: "
         "90}, tasks: [{do: route, waypoints: [{north_m: 2, east_m: 40, depth_m: 0}]}]}\n"
         "  - {name: uav, model: x500, start: {north_m: -30, east_m: 20, height_m: 12}, tasks: "
         "[{do: route, waypoints: [{north_m: 40, east_m: -10, height_m: 9}]}]}\n"
         "structures:\n"
         "  - {kind: cylinder, north_m: 12, east_m: 14, diameter_m: 6, top_height_m: 20, "
         "bottom_depth_m: 60}\n"
         "traffic: {vessels: [{mmsi: 7, name: FERRY, speed_m_s: 9, waypoints: [{north_m: 200, "
         "east_m: 60}, {north_m: -300, east_m: 55}]}]}\n"
         "clearance: {craft_m: 2, structure_m: 1}\n";
}

constexpr int steps_of_run = 400;

/// Rows of a run of that, at every barrier, and where it began.
struct Logged {
  RunLog log;
  std::vector<NearestPasses> nearest;
};
Logged logged(const ReadyRun& ready, const RunSettings& settings) {
  twin::Run run(ready.agents, ready.states, settings);
  Logged out;
  out.log.append(0, run.agents(), run.states());
  tests::step_and_log(run, steps_of_run, out.log);
  for (const AgentState& state : run.states()) out.nearest.push_back(state.nearest);
  return out;
}

TEST(ApproachWatch, SaysWhatReadingTheWholeLogSays) {
  const ReadyRun ready = tests::ready_of(passing_each_other());
  const Logged run = logged(ready, tests::settings_of(0.1));
  const std::size_t vehicles = ready.agents.size();
  std::vector<std::vector<Triple<double>>> at(vehicles);
  for (std::size_t i = 0; i < vehicles; ++i) {
    const auto x = run.log.column(i, "x"), y = run.log.column(i, "y"), z = run.log.column(i, "z");
    for (std::size_t t = 0; t < x.size(); ++t) at[i].push_back({y[t], x[t], -z[t]});
    for (const double halt : run.log.column(i, "halt")) ASSERT_EQ(halt, 0);
  }
  // By trying ten places between two rows.
  constexpr int tries = 10;
  const Structure& pile = ready.environment->structures.front();
  for (std::size_t i = 0; i < vehicles; ++i) {
    NearestPasses tried;
    double most_way_m = 0;
    for (std::size_t t = 1; t < at[i].size(); ++t)
      for (int k = 0; k <= tries; ++k) {
        const double share = double(k) / tries, now_s = run.log.t_s[t - 1] + 0.1 * share;
        const auto place = [&](std::size_t of) {
          return at[of][t - 1] + share * (at[of][t] - at[of][t - 1]);
        };
        for (std::size_t j = 0; j < vehicles; ++j)
          if (j != i) tried.vehicle.take(length_of(place(j) - place(i)), now_s, double(j));
        tried.structure.take(signed_distance_m(pile, place(i)), now_s, 0);
        const Triple<double> ferry = ready.vessels[0].track.at(now_s).position_m - place(i);
        tried.vessel.take(std::hypot(ferry.x, ferry.y), now_s, 7);
        most_way_m = std::max(most_way_m, length_of(at[i][t] - at[i][t - 1]));
      }
    const NearestPasses& told = run.nearest[i];
    for (const auto& [pass, by_trying] : {std::pair{told.vehicle, tried.vehicle},
                                          {told.structure, tried.structure},
                                          {told.vessel, tried.vessel}}) {
      EXPECT_LE(pass.distance_m, by_trying.distance_m + 1e-9) << i;
      EXPECT_NEAR(pass.distance_m, by_trying.distance_m, 0.01) << i;
      EXPECT_NEAR(pass.t_s, by_trying.t_s, 0.11) << i;
      EXPECT_EQ(pass.whom, by_trying.whom) << i;
    }
    EXPECT_GT(told.structure.distance_m, 0) << i;
    EXPECT_EQ(told.line.is_any(), i != 1) << "b has the only line";
    EXPECT_EQ(told.line.whom, i != 1 ? 1 : -1);
  }
}

TEST(ApproachWatch, SaysTheSameOnAnyThreadsInBlocksAndFromACheckpoint) {
  const ReadyRun ready = tests::ready_of(passing_each_other());
  const Logged expected = logged(ready, tests::settings_of(0.1));
  for (const std::size_t threads : {1U, 2U})
    for (const bool is_batch : {true, false}) {
      RunSettings settings = tests::settings_of(0.1);
      settings.threads = threads;
      settings.is_batch = is_batch;
      EXPECT_EQ(logged(ready, settings).nearest, expected.nearest) << threads << is_batch;
    }
  // In the middle of an approach, and long after it.
  const auto nearest_of_a = static_cast<int>(expected.nearest[0].vehicle.t_s / 0.1);
  for (const int before : {1, nearest_of_a, nearest_of_a + 1, 350}) {
    twin::Run first(ready.agents, ready.states, tests::settings_of(0.1));
    for (int i = 0; i < before; ++i) first.step();
    twin::Run second(ready.agents, ready.states, tests::settings_of(0.1));
    for (int i = 0; i < 20; ++i) second.step();
    second.restore(first.checkpoint());
    for (int i = before; i < steps_of_run; ++i) second.step();
    for (std::size_t i = 0; i < ready.agents.size(); ++i)
      EXPECT_EQ(second.states()[i].nearest, expected.nearest[i]) << before << " steps, " << i;
  }
}

TEST(ApproachWatch, ChangesNothingOfARun) {
  // What it keeps is no column of the log, and nobody reads it.
  ReadyRun ready = tests::ready_of(passing_each_other());
  const Logged expected = logged(ready, tests::settings_of(0.1));
  for (AgentState& state : ready.states) {
    state.nearest.vehicle = {0, 0, 0};
    state.nearest.structure = {0, 0, 0};
  }
  const Logged other = logged(ready, tests::settings_of(0.1));
  tests::expect_same_bits(other.log, expected.log, "of others' passes");
  EXPECT_NE(other.nearest, expected.nearest);
}

}  // namespace
}  // namespace slackwater::twin::approach_watch_test
