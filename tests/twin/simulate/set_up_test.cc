#include "fields/base/error.h"
#include "tests/support/temporary_folder.h"
#include "tests/twin/simulate/run_for_tests.h"

#include <fstream>

namespace slackwater::twin {
namespace {

const std::string whole = R"(name: pile
seed: 1
start: 2025-06-02T06:00:00Z
duration: 10min
step_s: 0.05
water: {made_up: {depth_m: 40, wind: {speed_m_s: 5, from_deg: 0}}}
structures:
  - {name: K7, kind: cylinder, north_m: 0, east_m: 30, diameter_m: 6, top_height_m: 20, bottom_depth_m: 40}
  - {name: frame, kind: box, north_m: 50, east_m: 0, north_size_m: 4, east_size_m: 4, top_height_m: -30, bottom_depth_m: 40}
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
}  // namespace slackwater::twin
