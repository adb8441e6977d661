#include "fields/base/error.h"
#include "fields/base/numbers/random.h"
#include "tests/support/temporary_folder.h"
#include "tests/twin/run/run_for_tests.h"
#include "twin/tether/lay_tether.h"
#include "twin/tether/tether_dynamics.h"

#include <fstream>

namespace slackwater::twin::set_up_test {
namespace {

const std::string whole = R"(name: pile
seed: 1
start: 2025-06-02T06:00:00Z
duration: 10min
step_s: 0.05
water: {made_up: {depth_m: 40, wind: {speed_m_s: 5, from_deg: 0}}}
structures:
  - {name: K7, kind: cylinder, north_m: 0, east_m: 30, diameter_m: 6, top_height_m: 20,
     bottom_depth_m: 40}
  - {name: frame, kind: box, north_m: 50, east_m: 0, north_size_m: 4, east_size_m: 4,
     top_height_m: -30, bottom_depth_m: 40}
vehicles:
  - name: rov
    model: bluerov2_heavy
    start: {north_m: 0, east_m: 0, depth_m: 10}
    tether: {top: {north_m: 0, east_m: -10, depth_m: 1}, length_m: 60}
    tasks:
      - {do: route, waypoints: [{north_m: 10, east_m: 0, depth_m: 12}]}
      - {do: hold, duration: 1min}
      - {do: route, waypoints: [{north_m: 10, east_m: 20, depth_m: 12}]}
  - {name: uav, model: x500, start: {north_m: 20, east_m: 0, height_m: 10}}
)";

std::string replaced(std::string yaml, const std::string& line, const std::string& instead) {
  const std::size_t at = yaml.find(line);
  EXPECT_NE(at, std::string::npos) << line;
  return yaml.replace(at, line.size(), instead);
}

std::string refusal(const Scenario& scenario, const Surround& surround) {
  try {
    (void)set_up(scenario, surround);
  } catch (const Error& problem) {
    EXPECT_EQ(problem.kind(), ErrorKind::invalid_input) << problem.message();
    return problem.message();
  }
  return "nothing was refused";
}

TEST(SetUp, TheWholeScenarioIsReady) {
  const ReadyRun ready = tests::ready_of(whole);
  ASSERT_EQ(ready.agents.size(), 2U);
  EXPECT_EQ(ready.agents[0].steps_per_barrier, 1U);
  // 0.05 s in steps of at most 0.004 s.
  EXPECT_EQ(ready.agents[1].steps_per_barrier, 13U);
  EXPECT_TRUE(ready.agents[0].tether.has_value());
}

struct Bad {
  const char* line;
  const char* instead;
  std::vector<const char*> says;
};

TEST(SetUp, RefusesWhatCannotBeRunWithAMessageThatHelps) {
  const Bad all[] = {
      {"model: bluerov2_heavy", "model: bluerov3", {"bluerov3", "bluerov2_heavy", "x500", "rov"}},
      {"model: bluerov2_heavy", "model: /nowhere/rov.yaml", {"/nowhere/rov.yaml"}},
      {"depth_m: 10}\n    tether",
       "depth_m: 41}\n    tether",
       {"vehicle rov", "the start", "below"}},
      {"start: {north_m: 0, east_m: 0, depth_m: 10}",
       "start: {north_m: 0, east_m: 31, depth_m: 10}",
       {"vehicle rov", "the start", "K7", "move it out"}},
      {"start: {north_m: 0, east_m: 0, depth_m: 10}",
       "start: {north_m: 0, east_m: 0, height_m: 3}",
       {"above the sea"}},
      {"height_m: 10}", "depth_m: 10}", {"vehicle uav", "below the sea"}},
      {"start: {north_m: 0, east_m: 0, depth_m: 10}",
       "start: {north_m: 0, east_m: 49000, depth_m: 10}",
       {"outside", "the start"}},
      {"start: 2025-06-02T06:00:00Z\nduration: 10min",
       "start: 2025-06-02T06:00:00Z\nduration: 3h",
       {"2025-06-02T09:00:00Z", "2025-06-02T08:00:00Z", "shorten"}},
      {"east_m: 0, depth_m: 12}", "east_m: 0, depth_m: 50}", {"waypoint 1 of task 1", "below"}},
      {"{north_m: 10, east_m: 20, depth_m: 12}",
       "{north_m: 0, east_m: 31, depth_m: 12}",
       {"waypoint 1 of task 3", "K7"}},
      {"{north_m: 10, east_m: 20, depth_m: 12}",
       "{north_m: -10, east_m: 60, depth_m: 12}",
       {"the way to waypoint 1 of task 3", "K7", "round"}},
      {"{north_m: 10, east_m: 0, depth_m: 12}",
       "{north_m: 70, east_m: 20, depth_m: 38}, {north_m: 70, east_m: 10, depth_m: 35}, {north_m: "
       "30, east_m: -10, depth_m: 36}",
       {"the way to waypoint 3 of task 1", "frame"}},
      {"length_m: 60", "length_m: 11", {"vehicle rov", "11"}},
      {"length_m: 60", "length_m: 500", {"vehicle rov", "500"}},
      {"height_m: 10}",
       "height_m: 10}, tether: {top: {north_m: 0, east_m: 0, height_m: 1}, length_m: 60}",
       {"vehicle uav", "no tether", "leave"}},
      {"seed: 1", "wakes: true\nseed: 1", {"turbines"}},
  };
  for (const Bad& bad : all) {
    const Scenario scenario = parse_scenario(replaced(whole, bad.line, bad.instead), "bad.yaml");
    Surround surround = tests::surround_of(parse_scenario(whole, "whole.yaml"));
    const std::string message = refusal(scenario, surround);
    for (const char* says : bad.says)
      EXPECT_NE(message.find(says), std::string::npos) << bad.instead << "\n-> " << message;
    EXPECT_EQ(message.find("vehicle rov: vehicle"), std::string::npos) << message;
    EXPECT_EQ(message.find("vehicle uav: vehicle"), std::string::npos) << message;
  }
}

/// The made-up water of the scenario on a grid of four by four columns, with land in its north-west
/// (the four columns there are missing, as in any product) and a bed at 12 m in its eastern half.
Surround coast(const Scenario& scenario) {
  Surround surround = tests::surround_of(scenario);
  auto snapshot = std::make_shared<Snapshot>(surround.field->snapshot());
  const ForecastColumn sample = snapshot->columns.front();
  snapshot->columns.clear();
  for (const double north : {-0.24, -0.08, 0.08, 0.24}) {
    for (const double east : {-0.24, -0.08, 0.08, 0.24}) {
      if (north > 0 && east < 0) continue;
      ForecastColumn column = sample;
      column.point = GeoPoint::from_degrees(surround.site.latitude_deg() + north,
                                            surround.site.longitude_deg() + east);
      column.water_depth_m = east > 0 ? 12 : 40;
      snapshot->columns.push_back(column);
    }
  }
  surround.field = std::make_shared<Field>(std::move(snapshot));
  return surround;
}

TEST(SetUp, AStartOnLandOrInTheBedOfTheForecastIsRefusedBeforeTheFirstStep) {
  const auto said = [](const std::string& start, const std::string& model) {
    const Scenario scenario = parse_scenario(
        "name: coast\nseed: 1\nduration: 1min\nstep_s: 0.05\nwater: {made_up: {depth_m: 40, wind: "
        "{speed_m_s: 5, from_deg: 0}}}\nvehicles:\n  - {name: it, model: " +
            model + ", start: " + start + "}\n",
        "coast.yaml");
    return refusal(scenario, coast(scenario));
  };
  const char* ashore = "{north_m: 17800, east_m: -10200, depth_m: 0}";
  for (const char* model : {"wamv16", "ctv24", "bluerov2_heavy", "lrauv_tethys"}) {
    const std::string message = said(ashore, model);
    EXPECT_NE(message.find("vehicle it: the start is land"), std::string::npos) << message;
    EXPECT_NE(message.find("move it"), std::string::npos) << message;
  }
  for (const char* model : {"bluerov2_heavy", "lrauv_tethys"}) {
    for (const char* depth : {"12.1", "11.95", "40"}) {
      // The middle of the hull still above the bed, its keel not: it would be aground at once.
      const std::string message =
          said("{north_m: 0, east_m: 10200, depth_m: " + std::string(depth) + "}", model);
      EXPECT_NE(message.find("vehicle it: the start is below"), std::string::npos)
          << model << depth << message;
    }
    EXPECT_EQ(said("{north_m: 0, east_m: 10200, depth_m: 11}", model), "nothing was refused");
  }
  // The wind of a forecast of the sea ends at the coast too.
  EXPECT_NE(said("{north_m: 17800, east_m: -10200, height_m: 20}", "x500").find("land"),
            std::string::npos);
}

TEST(SetUp, ATetherHangsAtRestFromTheFirstStep) {
  // In sheared current: what is felt at the vehicle is there at once and stays, and nothing in the
  // line moves.
  const ReadyRun ready =
      tests::ready_of(tests::head(0.05) +
                      "  - {name: rov, model: bluerov2_heavy, start: {north_m: 0, east_m: 20, "
                      "depth_m: 10}, tether: "
                      "{top: {north_m: 0, east_m: 0, depth_m: 1}, length_m: 40}}\n");
  const TetherState<double>& tether = ready.states[0].tether;
  for (const Triple<double>& v : tether.velocity_m_s) EXPECT_LT(std::sqrt(dot(v, v)), 1e-6);
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
  run.step();
  const double first_n = run.states()[0].tether_n;
  EXPECT_GT(first_n, 0.1);
  EXPECT_NEAR(first_n, tether.tension_n.back(), 0.02 * first_n);
}

TEST(SetUp, ATetherComesToRestWhereverTheVehicleStarts) {
  // Slack and taut, in still and in fast water, from the deck and from below.
  Rng rng(5, "set_up_test/tether");
  for (int trial = 0; trial < 40; ++trial) {
    const double speed = trial % 4 == 0 ? 0 : rng.uniform(0, 1.5);
    const double angle = rng.uniform(0, 2 * constants::pi);
    const double north = rng.uniform(-40, 40), east = rng.uniform(-40, 40);
    const double deep = rng.uniform(1, 55), top = trial % 3 == 0 ? -3 : rng.uniform(0, 40);
    const double length =
        std::max(10.0, std::hypot(north, east, deep - top) * rng.uniform(1.0, 1.6));
    char yaml[700];
    std::snprintf(
        yaml, sizeof yaml,
        "name: t\nseed: 1\nduration: 1min\nstep_s: 0.05\nwater: {made_up: {depth_m: 60, current: "
        "[{depth_m: 0, east_m_s: %g, north_m_s: %g}, {depth_m: 60, east_m_s: 0, north_m_s: "
        "0.1}]}}\nvehicles: [{name: rov, model: bluerov2_heavy, start: {north_m: %g, east_m: %g, "
        "depth_m: %g}, tether: {top: {north_m: 0, east_m: 0, %s: %g}, length_m: %g}}]\n",
        speed * std::cos(angle), speed * std::sin(angle), north, east, deep,
        top < 0 ? "height_m" : "depth_m", std::abs(top), length);
    const ReadyRun ready = tests::ready_of(yaml);
    // With its ends held it goes on hanging; slack in still water it may still sink by centimetres
    // a second.
    const Agent& agent = ready.agents[0];
    TetherState<double> tether = ready.states[0].tether;
    const BodyState<double>& body = ready.states[0].vehicle.body;
    const Triple<double> end_m =
        body.position_m + rotation_of(body.attitude).to_ned(agent.tether->attachment_m);
    const SteadyWater water = [&](double depth_m) {
      return agent.water->current({end_m.x, end_m.y, depth_m}, 0, 0).current_m_s;
    };
    for (int i = 0; i < 40; ++i) {
      (void)pull(*agent.tether, tether, TetherEnds<double>{agent.tether_top_m, {}, end_m, {}},
                 water_at_nodes(tether, agent.tether_top_m, end_m, water), 0.05);
      for (const Triple<double>& v : tether.velocity_m_s)
        ASSERT_LT(std::sqrt(dot(v, v)), 0.1) << yaml;
    }
    EXPECT_EQ(tether.whole, 1) << yaml;
  }
}

TEST(SetUp, AMemberThatTheForecastHasNotIsRefused) {
  Scenario scenario = parse_scenario(whole, "whole.yaml");
  scenario.member = 3;
  const std::string message = refusal(scenario, tests::surround_of(scenario));
  EXPECT_NE(message.find("found 3"), std::string::npos) << message;
  EXPECT_NE(message.find("0 to 0"), std::string::npos) << message;
}

TEST(SetUp, NumbersThatAreNoneAreRefused) {
  const double nan = std::nan("");
  for (const int which : {0, 1, 2}) {
    Scenario scenario = parse_scenario(whole, "whole.yaml");
    Triple<double>& start = scenario.vehicles[0].start_m;
    (which == 0 ? start.x : which == 1 ? start.y : start.z) = nan;
    EXPECT_NE(refusal(scenario, tests::surround_of(scenario)).find("the start"), std::string::npos)
        << which;
  }
  Scenario scenario = parse_scenario(whole, "whole.yaml");
  scenario.vehicles[0].tasks[0].waypoints[0].position_m.y = nan;
  EXPECT_NE(refusal(scenario, tests::surround_of(scenario)).find("waypoint 1 of task 1"),
            std::string::npos);
}

TEST(SetUp, AVehicleThatCannotBeIsRefusedWithItsFile) {
  const tests::TemporaryFolder folder;
  const std::filesystem::path data = tests::source_folder() / "data";
  std::ifstream in(data / "vehicles/bluerov2_heavy.yaml");
  const std::string rov(std::istreambuf_iterator<char>(in), {});
  const auto refusal_of = [&](const std::string& yaml) {
    const std::filesystem::path file = folder.path() / "odd.yaml";
    std::ofstream(file) << yaml;
    const Scenario scenario = parse_scenario(
        replaced(whole, "model: bluerov2_heavy", "model: " + file.string()), "odd scenario");
    return refusal(scenario, tests::surround_of(scenario));
  };
  EXPECT_EQ(refusal_of(rov), "nothing was refused");
  const std::size_t capacity = rov.find("capacity_ah:");
  ASSERT_NE(capacity, std::string::npos);
  const std::string was = rov.substr(capacity, rov.find('\n', capacity) - capacity);
  for (const char* instead : {"capacity_ah: 0", "capacity_ah: .nan", "capacity_ah: -5"}) {
    const std::string message = refusal_of(replaced(rov, was, instead));
    EXPECT_NE(message.find("capacity_ah"), std::string::npos) << message;
    EXPECT_NE(message.find("odd.yaml"), std::string::npos) << message;
    EXPECT_NE(message.find("vehicle rov"), std::string::npos) << message;
  }
  const std::string message = refusal_of(replaced(rov, "hotel_w:", "hotel_watt:"));
  EXPECT_NE(message.find("hotel_w"), std::string::npos) << message;
}

TEST(SetUp, AgentsOutliveWhatTheyWereSetUpFrom) {
  std::vector<Agent> agents;
  std::vector<AgentState> states;
  {
    ReadyRun ready = tests::ready_of(whole);
    agents = std::move(ready.agents);
    states = std::move(ready.states);
  }
  EXPECT_TRUE(has_value(agents[0].water->current({0, 0, 10}, 0, 0).status));
}

}  // namespace
}  // namespace slackwater::twin::set_up_test
