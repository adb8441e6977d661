#include "api/ask/render/seen_tethers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/twin/run/run_for_tests.h"
#include "twin/agent/hung_line.h"

namespace slackwater::tests::seen_tethers_test {
namespace {

twin::Scenario tethered(const std::string& current_m_s) {
  return twin::parse_scenario(
      R"(name: on a line
seed: 4
origin: {latitude_deg: 54, longitude_deg: 6}
start: 2025-06-10T11:00:00Z
duration: 10min
step_s: 0.05
water: {made_up: {depth_m: 40, current: [{depth_m: 0, east_m_s: )" +
          current_m_s + R"(, north_m_s: 0}]}}
waves: {from: calm}
vehicles:
  - name: rov
    model: bluerov2_heavy
    start: {north_m: 0, east_m: 0, depth_m: 15, heading_deg: 90}
    tether: {top: {north_m: -10, east_m: 0, depth_m: 0}, length_m: 25}
    tasks: [{do: hold}]
)",
      "test.yaml");
}

double length_of_way(const std::vector<twin::Triple<double>>& at_m) {
  double length_m = 0;
  for (std::size_t i = 0; i + 1 < at_m.size(); ++i) length_m += length_of(at_m[i + 1] - at_m[i]);
  return length_m;
}

std::vector<std::optional<twin::Carriage>> where(const twin::AgentState& state) {
  const twin::BodyState<double>& body = state.vehicle.body;
  return {twin::Carriage{body.position_m, twin::rotation_of(body.attitude), {}, {}}};
}

// The run's own line, which swung for four minutes, is the oracle.
TEST(SeenTethers, LieWhereThoseOfTheRunCameToRest) {
  const twin::Scenario scenario = tethered("0.3");
  const auto run = begun(twin::set_up(scenario, surround_of(scenario)), 0.05);
  for (int i = 0; i < 4800; ++i) run->step();
  const twin::ReadyRun ready = twin::set_up(scenario, surround_of(scenario));
  const auto there = where(run->states()[0]);
  const auto seen = api::seen_tethers(ready, scenario, there, run->time_s());
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(seen[0].name, "rov/tether");
  EXPECT_EQ(seen[0].diameter_m, 0.0076);
  const auto of_run = twin::hung_line(run->agents()[0], run->states()[0]);
  ASSERT_EQ(seen[0].at_m.size(), of_run.size());
  EXPECT_EQ(length_of(seen[0].at_m.front() - of_run.front()), 0);
  EXPECT_LT(length_of(seen[0].at_m.back() - of_run.back()), 1e-6);
  double furthest_east_m = 0;
  for (std::size_t i = 0; i < of_run.size(); ++i) {
    // Of 25 m: what still swings of it, and 16 stiff parts that lie a little otherwise each time.
    EXPECT_LT(length_of(seen[0].at_m[i] - of_run[i]), 0.5) << i;
    furthest_east_m = std::max(furthest_east_m, seen[0].at_m[i].y);
  }
  EXPECT_GT(furthest_east_m, 3) << "the current bows it";
  EXPECT_NEAR(length_of_way(seen[0].at_m), 25, 0.1);
}

/// Its home is 6 m below the deck: in the water, where a crane takes it.
TEST(SeenTethers, OfOneBesideItsCarrierIsWoundUp) {
  const twin::Scenario scenario = twin::parse_scenario(
      R"(name: from a deck
seed: 4
origin: {latitude_deg: 54, longitude_deg: 6}
start: 2025-06-10T11:00:00Z
duration: 10min
step_s: 0.05
water: {made_up: {depth_m: 40}}
waves: {from: calm}
vehicles:
  - {name: tender, model: wamv16, start: {north_m: 0, east_m: 0, depth_m: 0}, tasks: [{do: hold}]}
  - name: rov
    model: bluerov2_heavy
    start: {north_m: 1.5, east_m: 0, depth_m: 5}
    conduct: {}
    tether: {length_m: 30}
    carrier: {name: tender, forward_m: 1.5, up_m: 1}
    tasks: [{do: hold}]
)",
      "test.yaml");
  const twin::ReadyRun ready = twin::set_up(scenario, surround_of(scenario));
  std::vector<std::optional<twin::Carriage>> there{where(ready.states[0])[0],
                                                   where(ready.states[1])[0]};
  EXPECT_TRUE(api::seen_tethers(ready, scenario, there, 0).empty()) << "beside her";
  there[1]->position_m.x += 8;
  const auto out = api::seen_tethers(ready, scenario, there, 0);
  ASSERT_EQ(out.size(), 1U);
  EXPECT_NEAR(out[0].at_m.front().x, 1.5, 0.1) << "from her deck";
  EXPECT_LT(out[0].at_m.front().z, 0);
  there[0].reset();
  EXPECT_TRUE(api::seen_tethers(ready, scenario, there, 0).empty()) << "she is not there";
}

TEST(SeenTethers, OfOneThatIsNotThereOrHasPartedAreLeftOut) {
  const twin::Scenario scenario = tethered("0.1");
  const twin::ReadyRun ready = twin::set_up(scenario, surround_of(scenario));
  auto there = where(ready.states[0]);
  EXPECT_EQ(api::seen_tethers(ready, scenario, there, 0).size(), 1U);
  there[0]->position_m.y = 60;
  EXPECT_TRUE(api::seen_tethers(ready, scenario, there, 0).empty());
  EXPECT_TRUE(
      api::seen_tethers(ready, scenario, std::vector<std::optional<twin::Carriage>>(1), 0).empty());
}

}  // namespace
}  // namespace slackwater::tests::seen_tethers_test
