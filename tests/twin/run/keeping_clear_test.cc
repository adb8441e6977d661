#include "tests/twin/run/run_for_tests.h"

// The rule of twin/clearance in closed loop: the vehicles of data/ in current, wind and gusts.

namespace slackwater::twin::keeping_clear_test {
namespace {

std::string clearance(const std::string& distances) { return "clearance: {" + distances + "}\n"; }

std::string vehicle(const std::string& name, const std::string& model, double north_m,
                    double east_m, double to_north_m, double to_east_m, const std::string& vertical,
                    double heading_deg, const std::string& more = "") {
  const auto place = [&](double n, double e) {
    return "north_m: " + std::to_string(n) + ", east_m: " + std::to_string(e) + ", " + vertical;
  };
  return "  - {name: " + name + ", model: " + model + ", start: {" + place(north_m, east_m) +
         ", heading_deg: " + std::to_string(heading_deg) + "}, tasks: [{do: route, waypoints: [{" +
         place(to_north_m, to_east_m) + "}]}]" + more + "}\n";
}

struct Outcome {
  double least_m = 1e9;  ///< between the hulls of the first and any other at its depth
  std::vector<double> to_goal_m;
  std::vector<double> alarms;
  bool any_halted = false;
};

Outcome outcome_of(const ReadyRun& ready, double duration_s, double step_s = 0.1) {
  twin::Run run(ready.agents, ready.states, tests::settings_of(step_s));
  Outcome out;
  for (double t_s = 0; t_s < duration_s; t_s += step_s) {
    run.step();
    for (std::size_t i = 0; i < ready.agents.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const Triple<double> way = run.seen(i).position_m - run.seen(j).position_m;
        const double hulls_m =
            ready.agents[i].vehicle->body.radius_m + ready.agents[j].vehicle->body.radius_m;
        out.least_m = std::min(out.least_m, std::hypot(way.x, way.y) - hulls_m);
      }
  }
  for (std::size_t i = 0; i < ready.agents.size(); ++i) {
    const AgentState& state = run.states()[i];
    const Triple<double> goal = ready.agents[i].mission.tasks.back().waypoints.back().position_m;
    const Triple<double> way = goal - state.vehicle.body.position_m;
    out.to_goal_m.push_back(std::hypot(way.x, way.y));
    out.alarms.push_back(state.clearance.alarms);
    out.any_halted = out.any_halted || state.halt != Halt::none;
  }
  return out;
}

/// Three of one kind and one of another, head on and across each other.
ReadyRun four_that_meet() {
  return tests::ready_of(
      tests::head(0.1) + vehicle("a", "bluerov2_heavy", -6, 0, 8, 0, "depth_m: 10", 0) +
      vehicle("b", "bluerov2_heavy", 6, 0.4, -8, 0.4, "depth_m: 10", 180) +
      vehicle("c", "bluerov2_heavy", 0, -6, 0, 8, "depth_m: 10", 90) +
      vehicle("d", "wamv16", 0, 30, 0, -40, "depth_m: 0", 270) + clearance("craft_m: 2"));
}

RunLog log_of(const ReadyRun& ready, const RunSettings& settings) {
  twin::Run run(ready.agents, ready.states, settings);
  RunLog log;
  tests::step_and_log(run, 300, log);
  return log;
}

TEST(KeepingClearTogether, MakesTheSameBitsOnAnyThreadsInBlocksAndAfterACheckpoint) {
  const ReadyRun ready = four_that_meet();
  RunSettings plain = tests::settings_of(0.1);
  plain.is_batch = false;
  const RunLog expected = log_of(ready, plain);
  for (const std::size_t threads : {1U, 2U}) {
    for (const bool is_batch : {true, false}) {
      RunSettings settings = tests::settings_of(0.1);
      settings.threads = threads;
      settings.is_batch = is_batch;
      tests::expect_same_bits(log_of(ready, settings), expected,
                              std::to_string(threads) + " threads");
    }
  }
  twin::Run first(ready.agents, ready.states, plain);
  RunLog log;
  tests::step_and_log(first, 120, log);
  const twin::Run::Checkpoint checkpoint = first.checkpoint();
  EXPECT_GT(checkpoint.states[0].clearance.changed_s, 0) << "in the middle of giving way";
  twin::Run second(ready.agents, ready.states, plain);
  second.restore(checkpoint);
  tests::step_and_log(second, 180, log);
  tests::expect_same_bits(log, expected, "restored");
}

TEST(KeepingClearTogether, IsOffUnlessAskedFor) {
  const ReadyRun ready = tests::ready_of(
      tests::head(0.1) + vehicle("a", "bluerov2_heavy", 0, 0, 8, 0, "depth_m: 10", 0));
  EXPECT_FALSE(ready.agents.front().clearance);
}

/// A multirotor that is launched from a vessel under way, flies off and comes back aboard; or one
/// that only hovers where its deck would be.
ReadyRun vessel_and_multirotor(bool is_carried) {
  const std::string uav =
      is_carried
          ? "carrier: {name: usv, forward_m: 0, up_m: 3}, conduct: {}, tasks: [{do: aboard, "
            "duration_s: 30}, {do: route, waypoints: [{north_m: 60, east_m: 30, height_m: 20}]}, "
            "{do: aboard, duration_s: 10}]}\n"
          : "tasks: [{do: hold}]}\n";
  return tests::ready_of(
      tests::calm_head(0.02) +
      "  - {name: usv, model: wamv16, start: {north_m: 0, east_m: 0, depth_m: 0}, speed_m_s: 1, "
      "tasks: [{do: route, waypoints: [{north_m: 400, east_m: 0, depth_m: 0}]}]}\n"
      "  - {name: uav, model: x500, start: {north_m: 0, east_m: 0, height_m: 3}, " +
      uav + clearance("craft_m: 10, vertical_m: 5"));
}

TEST(KeepingClearOfACarrier, AboardLaunchedAndTakenBackNobodyIsAlarmedOrHeldUp) {
  const ReadyRun ready = vessel_and_multirotor(true);
  ASSERT_TRUE(ready.agents[0].clearance && ready.agents[1].clearance);
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.02));
  double nearest_in_the_air_m = 1e9;
  while (run.time_s() < 250 && !run.states()[1].conduct.has_ended) {
    run.step();
    const Triple<double> apart = run.seen(1).position_m - run.seen(0).position_m;
    if (!run.states()[1].conduct.is_aboard)
      nearest_in_the_air_m = std::min(nearest_in_the_air_m, length_of(apart));
  }
  EXPECT_TRUE(run.states()[1].conduct.has_ended && run.states()[1].conduct.is_aboard);
  EXPECT_LT(nearest_in_the_air_m, 6) << "within the stand-off, on its way off and on";
  for (const AgentState& state : run.states()) {
    EXPECT_EQ(state.clearance.alarms, 0);
    EXPECT_EQ(state.clearance.changed_s, 0);
    EXPECT_FALSE(state.nearest.vehicle.is_any()) << "the two do not count as passing each other";
  }
  // A stranger there alarms both.
  const ReadyRun strangers = vessel_and_multirotor(false);
  twin::Run other(strangers.agents, strangers.states, tests::settings_of(0.02));
  for (int i = 0; i < 20; ++i) other.step();
  for (const AgentState& state : other.states()) {
    EXPECT_EQ(state.clearance.alarms, 1);
    EXPECT_EQ(state.clearance.alarms_from[static_cast<std::size_t>(AlarmCause::vehicle)], 1);
  }
}

struct Kind {
  const char* model;
  const char* vertical;
  double apart_m;
  double craft_m;
  double duration_s;
  double arrived_m;
};
void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.model; }

class KeepingClear : public testing::TestWithParam<Kind> {};

TEST_P(KeepingClear, HeadOnAndCrossingEachPassesAndArrivesAndWithoutItTheyAreNearer) {
  const Kind k = GetParam();
  double least_without_m = k.craft_m;
  for (const bool crosses : {false, true}) {
    const double d = k.apart_m;
    const std::string both = vehicle("a", k.model, -d, 0.3, d, 0.3, k.vertical, 0) +
                             (crosses ? vehicle("b", k.model, 0, -d, 0, d, k.vertical, 90)
                                      : vehicle("b", k.model, d, -0.2, -d, -0.2, k.vertical, 180));
    const std::string head = tests::head(0.1, "{from: calm}", "dryden");
    const Outcome with = outcome_of(
        tests::ready_of(head + both + clearance("craft_m: " + std::to_string(k.craft_m))),
        k.duration_s);
    const Outcome without = outcome_of(tests::ready_of(head + both), k.duration_s);
    EXPECT_GE(with.least_m, k.craft_m) << (crosses ? "crossing" : "head on");
    least_without_m = std::min(least_without_m, without.least_m);
    EXPECT_FALSE(with.any_halted);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_LT(with.to_goal_m[i], k.arrived_m) << (crosses ? "crossing" : "head on") << i;
      EXPECT_EQ(with.alarms[i], 0) << i;
    }
  }
  EXPECT_LT(least_without_m, k.craft_m);
}

INSTANTIATE_TEST_SUITE_P(OfEachVehicle, KeepingClear,
                         testing::Values(Kind{"bluerov2_heavy", "depth_m: 10", 15, 2, 150, 1},
                                         Kind{"x500", "height_m: 30", 100, 5, 90, 2},
                                         Kind{"wamv16", "depth_m: 0", 60, 5, 200, 5},
                                         Kind{"ctv24", "depth_m: 0", 600, 20, 300, 30},
                                         Kind{"lrauv_tethys", "depth_m: 20", 200, 10, 900, 70}));

}  // namespace
}  // namespace slackwater::twin::keeping_clear_test
