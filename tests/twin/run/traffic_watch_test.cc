#include "twin/run/traffic_watch.h"
#include "fields/base/check.h"

#include <gtest/gtest.h>

#include "tests/twin/run/run_for_tests.h"
#include "twin/traffic/laid_track.h"

namespace slackwater::tests::traffic_watch_test {
namespace {

using namespace twin;

TrafficVessel vessel(std::uint32_t id, std::vector<Triple<double>> places, double speed_m_s) {
  TrafficVessel v;
  v.id = id;
  v.track = laid_track(places, speed_m_s, 0, 3600);
  return v;
}

/// A vehicle that goes north from the origin.
Seen north_at(double t_s, double speed_m_s) {
  return {{speed_m_s * t_s, 0, 0}, {speed_m_s, 0, 0}, Halt::none};
}

/// Half a second beyond the ten minutes, so that no look falls on a limit.
const AlarmLimits limits{500, 600.5, 1.25};

/// Looks each second.
void watch_for(TrafficWatch& watch, double from_s, double to_s, double speed_m_s) {
  for (double t = from_s; t <= to_s; ++t) {
    const Seen own = north_at(t, speed_m_s);
    watch.look(t, {&own, 1});
  }
}

TEST(TrafficWatch, HeadOnItRingsTenMinutesBeforeAndUntilTheMarginIsLeft) {
  // Both at 5 m/s on parallel ways 300 m apart, 10 km off: CPA 300 m, at 1000 s. TCPA falls below
  // 600.5 s after 399.5 s.
  TrafficWatch watch({vessel(7, {{10'000, 300, 0}, {-20'000, 300, 0}}, 5)}, limits, {{}});
  watch_for(watch, 0, 1200, 5);
  ASSERT_EQ(watch.records().size(), 1U);
  const AlarmRecord& alarm = watch.records()[0];
  EXPECT_EQ(alarm.mmsi, 7U);
  EXPECT_EQ(alarm.vehicle, 0U);
  EXPECT_EQ(alarm.begin_s, 400);
  EXPECT_NEAR(alarm.cpa_m, 300, 1e-6);
  EXPECT_NEAR(alarm.tcpa_s, 600, 1e-6);
  EXPECT_NEAR(alarm.least_distance_m, 300, 1e-6);
  EXPECT_EQ(alarm.least_distance_s, 1000);
  // Past, it is held while nearer than 1.25 x 500 m: sqrt(625^2 - 300^2) m at 10 m/s are 54.8 s.
  EXPECT_EQ(alarm.end_s, 1055);
  EXPECT_EQ(alarm.end, AlarmEnd::clear);
}

TEST(TrafficWatch, CrossingTheCpaIsThatOfStraightLines) {
  // It comes from the east at 8 m/s, the vehicle goes north at 4 m/s. With p = (2000, 6000),
  // v = (-4, -8): p.v = -56000, |v|^2 = 80, t = 700 s; |p x v| = |2000 (-8) + 6000 4| = 8000, over
  // sqrt(80): 894.4 m. Clear of 500 m, not of 900 m.
  for (const double cpa_m : {500.0, 900.0}) {
    TrafficWatch watch({vessel(1, {{2000, 6000, 0}, {2000, -20'000, 0}}, 8)}, {cpa_m, 600.5, 1.25},
                       {{}});
    watch_for(watch, 0, 800, 4);
    if (cpa_m < 600) {
      EXPECT_TRUE(watch.records().empty());
      continue;
    }
    ASSERT_EQ(watch.records().size(), 1U);
    EXPECT_EQ(watch.records()[0].begin_s, 100);
    EXPECT_NEAR(watch.records()[0].cpa_m, 8000 / std::sqrt(80.0), 1e-6);
    EXPECT_NEAR(watch.records()[0].tcpa_s, 600, 1e-6);
    EXPECT_NEAR(watch.records()[0].least_distance_m, 8000 / std::sqrt(80.0), 0.1);
    // sqrt(1125^2 - 800000) m at sqrt(80) m/s: 76.3 s.
    EXPECT_EQ(watch.records()[0].end_s, 777);
    EXPECT_EQ(watch.records()[0].end, AlarmEnd::clear);
  }
}

TEST(TrafficWatch, AVesselThatFallsSilentIsLostAndOneThatIsFollowedNoConcern) {
  // At anchor 100 m off, heard for 200 s.
  TrafficVessel silent = vessel(1, {{0, 100, 0}, {0, 101, 0}}, 0.005);
  ASSERT_DOUBLE_EQ(silent.track.points().back().t_s, 200);
  const TrafficVessel leader = vessel(2, {{0, 0, 0}, {3000, 0, 0}}, 1);
  TrafficVessel absent = vessel(3, {{0, 50, 0}}, 0);
  absent.is_around = false;
  TrafficWatch watch({silent, leader, absent}, limits, {{2}});
  watch_for(watch, 0, 300, 1);
  ASSERT_EQ(watch.records().size(), 1U);
  EXPECT_EQ(watch.records()[0].mmsi, 1U);
  EXPECT_EQ(watch.records()[0].begin_s, 0);
  EXPECT_EQ(watch.records()[0].end_s, 201);
  EXPECT_EQ(watch.records()[0].end, AlarmEnd::lost);
}

TEST(TrafficWatch, AVehicleThatGoesNoFurtherHasNoAlarmsAndTheOthersHave) {
  TrafficWatch watch({vessel(1, {{0, 100, 0}}, 0)}, limits, {{}, {}});
  for (double t = 0; t <= 20; ++t) {
    std::array<Seen, 2> seen{};
    if (t >= 10) seen[1].halt = Halt::aground;
    watch.look(t, seen);
  }
  ASSERT_EQ(watch.records().size(), 2U);
  EXPECT_EQ(watch.records()[0].end, AlarmEnd::still_on);
  EXPECT_EQ(watch.records()[0].end_s, 20);
  EXPECT_EQ(watch.records()[1].end, AlarmEnd::halted);
  EXPECT_EQ(watch.records()[1].end_s, 10);
}

TEST(TrafficWatch, GoesOnFromWhatItKept) {
  const std::vector<TrafficVessel> vessels{vessel(7, {{10'000, 300, 0}, {-20'000, 300, 0}}, 5),
                                           vessel(8, {{4000, -100, 0}}, 0)};
  TrafficWatch whole(vessels, limits, {{}}), first(vessels, limits, {{}}),
      second(vessels, limits, {{}});
  watch_for(whole, 0, 1200, 5);
  watch_for(first, 0, 700, 5);
  EXPECT_EQ(first.records().back().end, AlarmEnd::still_on);
  second.restore(first.state());
  watch_for(second, 701, 1200, 5);
  ASSERT_EQ(second.records().size(), whole.records().size());
  for (std::size_t i = 0; i < whole.records().size(); ++i) {
    EXPECT_EQ(second.records()[i].begin_s, whole.records()[i].begin_s);
    EXPECT_EQ(second.records()[i].end_s, whole.records()[i].end_s);
    EXPECT_EQ(second.records()[i].least_distance_m, whole.records()[i].least_distance_m);
    EXPECT_EQ(second.records()[i].end, whole.records()[i].end);
  }
  EXPECT_THROW(second.restore({}), ContractViolation);
}

const std::string meeting =
    calm_head(0.1) +
    "  - {name: usv, model: wamv16, speed_m_s: 1.5, start: {north_m: 0, east_m: 0, depth_m: 0}, "
    "tasks: [{do: route, waypoints: [{north_m: 2000, east_m: 0, depth_m: 0}]}]}\n"
    "traffic:\n  alarm: {cpa_m: 200, tcpa_min: 2}\n  vessels:\n"
    "    - {mmsi: 1, name: FERRY, speed_m_s: 6, waypoints: [{north_m: 1000, east_m: 50}, {north_m: "
    "-1000, east_m: 50}]}\n";

TEST(TrafficWatch, InARunTheAlarmsAreThoseOfItsBarriersHoweverItIsStepped) {
  const ReadyRun ready = ready_of(meeting);
  ASSERT_EQ(ready.vessels.size(), 1U);
  std::vector<TrafficWatch::State> states;
  for (const std::size_t threads : {1U, 2U, 4U}) {
    RunSettings settings = settings_of(0.1);
    settings.threads = threads;
    settings.is_batch = threads != 2;
    twin::Run run(ready.agents, ready.states, settings);
    TrafficWatch watch(ready.vessels, {200, 120, 1.25}, {{}});
    keep_watch(watch, run, 0.1);
    for (int i = 0; i < 2000; ++i) run.step();
    states.push_back(watch.state());
  }
  for (const TrafficWatch::State& state : states) {
    ASSERT_EQ(state.records.size(), 1U);
    const AlarmRecord& alarm = state.records[0];
    EXPECT_EQ(alarm.begin_s, states[0].records[0].begin_s);
    EXPECT_EQ(alarm.cpa_m, states[0].records[0].cpa_m);
    EXPECT_EQ(alarm.least_distance_m, states[0].records[0].least_distance_m);
    // 1000 m at 7.5 m/s: two minutes before the meeting are some 13 s after the start.
    EXPECT_NEAR(alarm.begin_s, 14, 4);
    EXPECT_NEAR(alarm.least_distance_m, 50, 3);
    EXPECT_EQ(alarm.end, AlarmEnd::clear);
  }
}

}  // namespace
}  // namespace slackwater::tests::traffic_watch_test
