// What a live run calls its vehicles, and when it calls them home.
#include <limits>

#include "api/door/live/live_run.h"
#include "api/door/live/topics/reserve_advice.h"
#include "tests/twin/run/run_for_tests.h"

namespace slackwater::tests::live_words_test {
namespace {

std::vector<std::string> names_of(const std::vector<std::string>& vehicles) {
  std::vector<twin::Agent> agents(vehicles.size());
  for (std::size_t i = 0; i < vehicles.size(); ++i) agents[i].name = vehicles[i];
  return live::ros_names(agents);
}

TEST(RosNames, AreTokensAndEachStandsOnce) {
  EXPECT_EQ(names_of({"ROV 1", "rov-1", "rov 1", "7 north"}),
            (std::vector<std::string>{"ROV_1", "rov_1_2", "rov_1_3", "n7_north"}));
  EXPECT_EQ(names_of({"ais", "clock", "slackwater"}),
            (std::vector<std::string>{"ais_2", "clock_2", "slackwater_2"}))
      << "topics of the run";
}

TEST(ReserveAdvice, SaysByWhenToTurnForHome) {
  const UtcTime now = parse_utc("2025-06-02T14:00:00Z");
  constexpr double endless = std::numeric_limits<double>::infinity();
  EXPECT_EQ(live::advice_of(90.9, now), "come home by 2025-06-02T14:01:30Z") << "not a second late";
  EXPECT_EQ(live::advice_of(0, now), "come home now: the reserve is needed");
  EXPECT_EQ(live::advice_of(-5, now), "come home now: the reserve is needed");
  EXPECT_NE(live::advice_of(-endless, now).find("faster than the vehicle"), std::string::npos);
  EXPECT_NE(live::advice_of(endless, now).find("it need not come home"), std::string::npos);
}

/// With 40 Wh left of a pack, a steady draw and home beside it, what is left less a fifth of the
/// whole lasts as long as that draw takes for it.
TEST(ReserveAdvice, IsWhatIsLeftOverWhatItDraws) {
  const twin::ReadyRun ready = ready_of(
      calm_head(0.05) +
      "  - {name: rov, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: 10}}\n");
  const twin::Agent& agent = ready.agents[0];
  twin::AgentState state = ready.states[0];
  live::ReserveAdvice advice(state, 0);
  const UtcTime now = parse_utc("2025-06-02T14:00:00Z");
  constexpr double power_w = 100;
  state.vehicle.drawn_j += 10 * power_w;
  const dds::Reserve reserve = advice.look(agent, state, now, 10);
  const twin::Battery& battery = *agent.vehicle->battery;
  const double full_j = twin::open_circuit_energy_j(battery, 1, 0);
  EXPECT_NEAR(reserve.energy_left_j, full_j, 1e-6 * full_j);
  EXPECT_EQ(reserve.energy_home_j, 0) << "it has not gone";
  EXPECT_NEAR(reserve.margin_s, 0.8 * full_j / power_w, 1e-6 * reserve.margin_s);
  // A hundred metres off, in still water: the straight way at its cruising speed.
  state.vehicle.body.position_m.x += 100;
  const dds::Reserve away = advice.look(agent, state, now, 10);
  EXPECT_NEAR(away.energy_home_j, 100 / agent.vehicle->cruise_speed_m_s * power_w, 1e-6 * full_j);
  EXPECT_NEAR(away.margin_s, (0.8 * full_j - 1.3 * away.energy_home_j) / power_w, 1);
  // One that joins late drew nothing before.
  live::ReserveAdvice of_newcomer(ready.states[0], 3600);
  state.vehicle.body.position_m.x -= 100;
  const dds::Reserve joined = of_newcomer.look(agent, state, now, 3610);
  EXPECT_NEAR(joined.margin_s, 0.8 * full_j / power_w, 1e-6 * reserve.margin_s);
}

}  // namespace
}  // namespace slackwater::tests::live_words_test
