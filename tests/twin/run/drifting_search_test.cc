#include "fields/base/text.h"
#include "tests/support/error_of.h"
#include "tests/twin/run/run_for_tests.h"
#include "twin/agent/follow_datum.h"

namespace slackwater::tests::drifting_search_test {
namespace {

using twin::Triple;

/// What flows and blows.
struct Weather {
  double north_m_s = 0;
  double east_m_s = 0;
  double wind_m_s = 0;  ///< from the west
};

std::string head_of(const Weather& weather, const std::string& more = "") {
  return formatted(
             "name: test\nseed: 3\nduration: 30min\nstep_s: 0.05\nlog_every_s: 1\nwater: "
             "{{made_up: "
             "{{depth_m: 40, current: [{{depth_m: 0, east_m_s: {}, north_m_s: {}}}], wind: "
             "{{speed_m_s: {}, from_deg: 270}}}}}}\nwaves: {{from: calm}}\n",
             weather.east_m_s, weather.north_m_s, weather.wind_m_s) +
         more + "vehicles:\n";
}

/// A vehicle that searches three lines of 60 m about a place north of it.
std::string searcher(const std::string& model, const std::string& level, const std::string& frame,
                     const std::string& search = "object: drift_buoy, elapsed_s: 0",
                     const std::string& more = "", const std::string& name = "searcher") {
  const auto at = [&](double north, double east) {
    return formatted("{{north_m: {}, east_m: {}, {}}}", north, east, level);
  };
  return "  - {name: " + name + ", model: " + model + ", start: " + at(0, 0) +
         ", conduct: {search: {lookout: small_boat, radius_m: 15, visibility_m: 50, last_known: "
         "{north_m: 40, east_m: 20}, " +
         search + "}" + more + "}, tasks: [{do: route, phase: work, frame: " + frame +
         ", waypoints: [" + at(10, 0) + ", " + at(70, 0) + ", " + at(70, 20) + ", " + at(10, 20) +
         ", " + at(10, 40) + ", " + at(70, 40) + "]}, {do: route, phase: return, waypoints: [" +
         at(0, 0) + "]}]}\n";
}

/// Begins with the water's motion, so that it rests in it.
std::unique_ptr<twin::Run> run_of(const std::string& yaml, const Weather& weather = {},
                                  std::size_t threads = 1, bool is_batch = true) {
  twin::ReadyRun ready = ready_of(yaml);
  for (twin::AgentState& state : ready.states) {
    twin::BodyState<double>& body = state.vehicle.body;
    body.nu.linear = twin::rotation_of(body.attitude)
                         .to_body(Triple<double>{weather.north_m_s, weather.east_m_s, 0});
  }
  return begun(std::move(ready), 0.05, threads, is_batch);
}

Triple<double> place_of(twin::Run& run, std::size_t i = 0) {
  return run.states()[i].vehicle.body.position_m;
}

struct Craft {
  const char* model;
  const char* level;
  double within_m;  ///< rounding; what the air makes of it that rests over ground
};

TEST(DriftingSearch, IsInTheWatersFrameWhatAFixedOneIsInStillWater) {
  const Weather streams{0.15, 0.35, 0};
  for (const Craft& craft :
       {Craft{"bluerov2_heavy", "depth_m: 10", 1e-4}, Craft{"wamv16", "depth_m: 0", 0.5}}) {
    const auto still = run_of(head_of({}) + searcher(craft.model, craft.level, "fixed"));
    const auto adrift =
        run_of(head_of(streams) + searcher(craft.model, craft.level, "drifting"), streams);
    double most_m = 0;
    bool is_at_it = true;
    while (is_at_it) {
      still->step();
      adrift->step();
      const double t_s = still->time_s();
      const Triple<double> carried =
          place_of(*adrift) - Triple<double>{t_s * streams.north_m_s, t_s * streams.east_m_s, 0};
      is_at_it = still->states()[0].mission.task == 0 && t_s < 1200;
      if (is_at_it) most_m = std::max(most_m, twin::length_of(carried - place_of(*still)));
    }
    EXPECT_LT(most_m, craft.within_m) << craft.model;
    EXPECT_GT(still->time_s(), 60) << craft.model;
    // Who is found is found at the same time: the person rests in the water too.
    EXPECT_EQ(still->states()[0].conduct.search.is_found,
              adrift->states()[0].conduct.search.is_found);
    EXPECT_EQ(still->states()[0].conduct.search.found_s,
              adrift->states()[0].conduct.search.found_s);
    EXPECT_EQ(adrift->states()[0].halt, twin::Halt::none);
  }
}

TEST(DriftingSearch, BeginsWhereThePersonIsThoughtToBeAndGoesWithHim) {
  const Weather streams{0, 0.3, 8};
  const auto run =
      run_of(head_of(streams) + searcher("wamv16", "depth_m: 0", "drifting",
                                         "object: life_raft_deep_ballast, elapsed: 5min"));
  const twin::LeewayObject& raft = run->agents()[0].conduct->plan.search->drifts;
  const Triple<double> drift = twin::expected_drift(raft, {0, 0.3, 0}, {0, 8, 0});
  EXPECT_GT(drift.y, 0.4);
  while (run->time_s() < 100) run->step();
  const twin::MovingFrame frame = datum_frame(run->agents()[0], run->states()[0], 100);
  EXPECT_NEAR(frame.velocity_m_s.y, drift.y, 0.02);  // the wind of 10 m and that of the field
  EXPECT_NEAR(frame.offset_m.y, 400 * drift.y, 8);
  EXPECT_NEAR(run->states()[0].mission.offset_m.y, frame.offset_m.y - 0.05 * frame.velocity_m_s.y,
              1e-9);
}

TEST(DriftingSearch, ComesHomeToAPlaceThatStaysWhereItIs) {
  const Weather streams{0.1, 0.3, 0};
  for (const Craft& craft : {Craft{"wamv16", "depth_m: 0", 3}, Craft{"x500", "height_m: 30", 1}}) {
    const auto run =
        run_of(head_of(streams) + searcher(craft.model, craft.level, "drifting"), streams);
    while (run->time_s() < 1500 && !run->all_ended()) run->step();
    EXPECT_TRUE(run->all_ended()) << craft.model;
    EXPECT_EQ(run->states()[0].halt, twin::Halt::none);
    const Triple<double> here = place_of(*run);
    EXPECT_LT(std::hypot(here.x, here.y), craft.within_m) << craft.model;
  }
}

TEST(DriftingSearch, TakesUpItsPatternWhereThatHasDriftedTo) {
  const Weather streams{0, 0.4, 0};
  const auto run =
      run_of(head_of(streams) +
                 searcher("wamv16", "depth_m: 0", "drifting", "object: drift_buoy, elapsed_s: 0",
                          ", autonomy: shared, holding: {overlap_m: 0}, faults: [{fault: "
                          "lost_link, at_s: 40, for_s: 200}]"),
             streams);
  while (run->time_s() < 39.99) run->step();
  const Triple<double> left_m = place_of(*run) - Triple<double>{0, 0.4 * 40, 0};
  double nearest_m = 1e9;
  bool was_back = false;
  while (run->time_s() < 600 && !was_back) {
    run->step();
    const double t_s = run->time_s();
    if (t_s < 241) continue;
    const Triple<double> off = place_of(*run) - Triple<double>{0, 0.4 * t_s, 0} - left_m;
    nearest_m = std::min(nearest_m, std::hypot(off.x, off.y));
    was_back = run->states()[0].conduct.doing == twin::Doing::task;
  }
  EXPECT_TRUE(was_back);
  // Eighty metres on; its way back leads to where that was when it set out.
  EXPECT_LT(nearest_m, 20);
  EXPECT_LT(run->states()[0].mission.route.next(), 5U);
}

const std::string pile =
    "structures:\n  - {name: pile, kind: cylinder, north_m: 40, east_m: 75, diameter_m: 6, "
    "top_height_m: 90, bottom_depth_m: 40, turns_current: true}\n";

TEST(DriftingSearch, GoesRoundWhatThePatternIsCarriedOver) {
  const Weather streams{0, 0.3, 0};
  for (const Craft& craft : {Craft{"wamv16", "depth_m: 0", 3}, Craft{"x500", "height_m: 30", 3}}) {
    const auto run =
        run_of(head_of(streams, pile) + searcher(craft.model, craft.level, "drifting"), streams);
    double nearest_m = 1e9;
    while (run->time_s() < 1500 && !run->all_ended()) {
      run->step();
      const Triple<double> here = place_of(*run);
      nearest_m = std::min(nearest_m, std::hypot(here.x - 40, here.y - 75) - 3);
    }
    EXPECT_TRUE(run->all_ended()) << craft.model;
    EXPECT_EQ(run->states()[0].halt, twin::Halt::none) << craft.model;
    EXPECT_GT(nearest_m, 2.5) << craft.model;
    EXPECT_LT(nearest_m, 40) << craft.model << ": it did not come there";
  }
}

TEST(DriftingSearch, IsTheSameToTheBitHoweverItIsSteppedAndTakenUp) {
  const Weather streams{0.1, 0.3, 6};
  std::string yaml = head_of(streams, pile);
  for (int i = 0; i < 3; ++i)
    yaml += searcher("wamv16", "depth_m: 0", "drifting",
                     "object: person_upright, elapsed: 2min, person: p" + std::to_string(i),
                     ", autonomy: shared, pilot: {wander_m: 0.5}, envelope: {fence_m: 400}",
                     "s" + std::to_string(i));
  const auto made = [&](std::size_t threads, bool is_batch) {
    return run_of(yaml, streams, threads, is_batch);
  };
  twin::RunLog first, second, third, taken_up;
  const auto a = made(1, true), b = made(2, true), c = made(1, false), d = made(1, true),
             e = made(1, true);
  step_and_log(*a, 2400, first);
  step_and_log(*b, 2400, second);
  step_and_log(*c, 2400, third);
  step_and_log(*d, 900, taken_up);
  e->restore(d->checkpoint());
  step_and_log(*e, 1500, taken_up);
  expect_same_bits(first, second, "two threads");
  expect_same_bits(first, third, "one by one");
  expect_same_bits(first, taken_up, "taken up");
}

TEST(DriftingSearch, IsRefusedToWhoSearchesForNobody) {
  const auto message = [](const std::string& yaml) {
    return error_of([&] { return ready_of(yaml); });
  };
  const std::string good = head_of({}) + searcher("wamv16", "depth_m: 0", "drifting");
  EXPECT_EQ(message(good), "no error");
  std::string bad = good;
  bad.replace(bad.find("drifting"), 8, "sideways");
  EXPECT_NE(message(bad).find("expected fixed or drifting"), std::string::npos) << message(bad);
  bad = good;
  bad.replace(bad.find("search: {"), bad.find("}}, tasks") + 1 - bad.find("search: {"), "");
  EXPECT_NE(message(bad).find("without a search for a person"), std::string::npos) << message(bad);
  bad = good;
  bad.replace(bad.find("{do: route, phase: return"), 25, "{do: hold, frame: drifting}, {do: route");
  EXPECT_NE(message(bad).find("without waypoints"), std::string::npos) << message(bad);
}

}  // namespace
}  // namespace slackwater::tests::drifting_search_test
