#include <gtest/gtest.h>

#include "fields/base/error.h"
#include "twin/scenario/scenario.h"

namespace slackwater::twin::read_scenario_test {
namespace {

const std::string whole = R"(name: along the pile
seed: 7
start: 2025-06-02T06:00:00Z
duration: 10min
step_s: 0.05
log_every_s: 1
water:
  made_up:
    depth_m: 40
    current: [{depth_m: 0, east_m_s: 0.4, north_m_s: 0}, {depth_m: 40, east_m_s: 0.1, north_m_s: 0}]
    wind: {speed_m_s: 8, from_deg: 270}
waves: {partitions: [{significant_height_m: 1, peak_period_s: 6, from_deg: 270}], components: 64}
structures:
  - {kind: cylinder, north_m: 0, east_m: 30, diameter_m: 6, top_height_m: 20,
     bottom_depth_m: 40}
vehicles:
  - name: rov
    model: bluerov2_heavy
    start: {north_m: 0, east_m: 0, depth_m: 10, heading_deg: 90}
    tasks:
      - {do: route, waypoints: [{north_m: 10, east_m: 0, depth_m: 12, speed_m_s: 0.5}]}
      - {do: orbit, centre: {north_m: 0, east_m: 30, depth_m: 12}, radius_m: 8, turns: 2,
         end_depth_m: 30}
      - {do: hold, duration: 2min}
)";

TEST(ReadScenario, HasWhatTheFileSays) {
  const Scenario s = parse_scenario(whole, "whole.yaml");
  EXPECT_EQ(s.name, "along the pile");
  EXPECT_EQ(s.seed, 7U);
  EXPECT_DOUBLE_EQ(s.duration_s, 600);
  EXPECT_EQ(s.waves.components, 64U);
  EXPECT_DOUBLE_EQ(s.waves.made_up.significant_height_m(), 1);
  ASSERT_EQ(s.vehicles.size(), 1U);
  EXPECT_DOUBLE_EQ(s.vehicles[0].start_m.z, 10);
  ASSERT_EQ(s.vehicles[0].tasks.size(), 3U);
  EXPECT_DOUBLE_EQ(s.vehicles[0].tasks[1].waypoints.back().position_m.z, 30);
  EXPECT_DOUBLE_EQ(s.vehicles[0].tasks[2].hold_s, 120);
  EXPECT_EQ(s.yaml, whole);
}

std::string refusal(const std::string& line, const std::string& instead) {
  std::string yaml = whole;
  const std::size_t at = yaml.find(line);
  EXPECT_NE(at, std::string::npos) << line;
  yaml.replace(at, line.size(), instead);
  try {
    (void)parse_scenario(yaml, "bad.yaml");
  } catch (const Error& problem) {
    EXPECT_EQ(problem.kind(), ErrorKind::invalid_input);
    return problem.message();
  }
  return "nothing was refused";
}

TEST(ReadScenario, NavigatesByTheTruthUnlessTheRunOrTheVehicleSaysOtherwise) {
  const auto by_sensors = [](const char* of_run, const char* of_vehicle) {
    std::string yaml = whole;
    yaml.insert(yaml.find("duration"), of_run);
    yaml.insert(yaml.find("    model"), of_vehicle);
    const Scenario s = parse_scenario(yaml, "navigation.yaml");
    return s.vehicles[0].navigates_by_sensors;
  };
  EXPECT_FALSE(by_sensors("", ""));
  EXPECT_TRUE(by_sensors("navigation: sensors\n", ""));
  EXPECT_TRUE(by_sensors("", "    navigation: sensors\n"));
  EXPECT_FALSE(by_sensors("navigation: sensors\n", "    navigation: truth\n"));
  EXPECT_FALSE(parse_scenario(whole, "whole.yaml").logs_sensors);
  const Scenario logged = parse_scenario("log: {sensors: true}\n" + whole, "log.yaml");
  EXPECT_TRUE(logged.logs_sensors);
  EXPECT_TRUE(logged.vehicles[0].logs_sensors);
}

/// In the place of the waves of the whole one, on line 12.
std::string with_waves(const std::string& waves) {
  std::string yaml = whole;
  const std::size_t at = yaml.find("waves: "), end = yaml.find('\n', at);
  return yaml.replace(at, end - at, "waves: " + waves);
}

TEST(ReadScenario, HasARegularWaveInThePlaceOfASea) {
  for (const char* const from : {"", "from: regular, "}) {
    const Scenario s =
        parse_scenario(with_waves(std::string("{") + from +
                                  "regular: {height_m: 0.4, period_s: 5, from_deg: 270}}"),
                       "regular.yaml");
    EXPECT_FALSE(s.waves.from_forecast);
    EXPECT_EQ(s.waves.regular, (RegularWave{0.4, 5, 270}));
    EXPECT_TRUE(s.waves.made_up.partitions.empty());
  }
}

TEST(ReadScenario, RefusesARegularWaveThatCannotBeWithItsLine) {
  for (const auto& [waves, words] : {
           std::pair{"{regular: {height_m: 4, period_s: 4, from_deg: 0}}",
                     "regular.yaml:12: waves.regular.height_m: found H 4 m with T 4 s"},
           {"{regular: {height_m: 0, period_s: 4, from_deg: 0}}", "0.001"},
           {"{regular: {height_m: 1, period_s: 0.3, from_deg: 0}}", "period_s"},
           {"{regular: {height_m: 1, period_s: 31, from_deg: 0}}", "30"},
           {"{regular: {height_m: 1, period_s: 9}}", "from_deg"},
           {"{regular: {height_m: 1, period_s: 9, from_deg: 0, to_deg: 0}}", "to_deg"},
           {"{regular: {height_m: 1, period_s: 9, from_deg: 0}, components: 9}",
            "found beside regular, which is one wave"},
           {"{regular: {height_m: 1, period_s: 9, from_deg: 0}, partitions: []}",
            "found beside regular, which is one wave"},
           {"{from: calm, regular: {height_m: 1, period_s: 9, from_deg: 0}}",
            "found beside from: calm"},
           {"{from: regular}", "regular"},
       }) {
    try {
      (void)parse_scenario(with_waves(waves), "regular.yaml");
      ADD_FAILURE() << waves << " is not refused";
    } catch (const Error& problem) {
      EXPECT_NE(problem.message().find(words), std::string::npos) << problem.message();
      EXPECT_NE(problem.message().find("regular.yaml:12"), std::string::npos) << problem.message();
    }
  }
}

struct Bad {
  const char* line;
  const char* instead;
  const char* says;
};

TEST(ReadScenario, RefusesWhatCannotBe) {
  const Bad all[] = {
      {"seed: 7", "sead: 7", "seed"},
      {"seed: 7", "seed: -1", "-1"},
      {"seed: 7", "seed: 7\nnavigation: stars", "stars"},
      {"seed: 7", "seed: 7\nlog: {sensor: true}", "sensors"},
      {"seed: 7", "seed: 7\ntasks: [{do: hold}]", "below a vehicle"},
      {"duration: 10min", "duration: 10", "10"},
      {"duration: 10min", "duration: 0min", "expected"},
      {"step_s: 0.05", "step_s: 50", "50"},
      {"step_s: 0.05", "step_s: .nan", "nan"},
      {"log_every_s: 1", "log_every_s: 0.07", "whole number"},
      {"start: 2025-06-02T06:00:00Z", "start: yesterday", "yesterday"},
      {"depth_m: 40\n", "depth_m: .nan\n", "nan"},
      {"{depth_m: 40, east", "{depth_m: 0, east", "below the level"},
      {"east_m_s: 0.4", "east_m_s: 40", "40"},
      {"significant_height_m: 1", "significant_height_m: 4", "steep"},
      {"kind: cylinder", "kind: blob", "blob"},
      {"bottom_depth_m: 40", "bottom_depth_m: -40", "top"},
      {"depth_m: 10, heading", "depth_m: 10, height_m: 3, heading", "one of the two"},
      {"model: bluerov2_heavy", "modell: bluerov2_heavy", "model"},
      {"do: route", "do: fly", "fly"},
      {"waypoints: [{north_m: 10, east_m: 0, depth_m: 12, speed_m_s: 0.5}]", "waypoints: []",
       "0 waypoints"},
      {"speed_m_s: 0.5", "speed_kn: 1", "speed_kn"},
      {"speed_m_s: 0.5", "speed_m_s: 0.5, ground_speed_m_s: 0.5", "one of the two"},
      {"    model:", "    ground_speed_m_s: 1\n    speed_m_s: 1\n    model:", "one of the two"},
      {"speed_m_s: 0.5", "speed_m_s: 0", "0.01"},
      {"do: route", "do: route, speed_m_s: 1, ground_speed_m_s: 1", "one of the two"},
      {"north_m: 10", "north_m: 1e9", "1e"},
      {"water:\n", "member: 3\nwater:\n", "members"},
      {"partitions:", "height_errors: true, partitions:", "height_errors"},
  };
  for (const Bad& bad : all) {
    const std::string message = refusal(bad.line, bad.instead);
    EXPECT_NE(message.find(bad.says), std::string::npos) << bad.instead << "\n-> " << message;
    EXPECT_NE(message.find("bad.yaml"), std::string::npos) << message;
  }
}

TEST(ReadScenario, ASpeedMayBeOverGroundForAWaypointATaskOrAVehicle) {
  const auto with = [](const std::string& line, const std::string& instead) {
    std::string yaml = whole;
    yaml.replace(yaml.find(line), line.size(), instead);
    return parse_scenario(yaml, "speeds.yaml").vehicles[0];
  };
  const auto first = [](const ScenarioVehicle& v) { return v.tasks[0].waypoints[0]; };
  const std::string own = ", speed_m_s: 0.5", line = "do: route";
  EXPECT_EQ(first(with(own, own)).over_ground, 0);
  EXPECT_EQ(first(with(own, ", ground_speed_m_s: 0.4")).over_ground, 1);
  EXPECT_EQ(first(with(own, ", ground_speed_m_s: 0.4")).speed_m_s, 0.4);
  // Of a task, where a waypoint has none of its own.
  EXPECT_EQ(first(with(line, "do: route, ground_speed_m_s: 0.3")).speed_m_s, 0.5);
  EXPECT_EQ(first(with(line, "do: route, ground_speed_m_s: 0.3")).over_ground, 0);
  std::string yaml = whole;
  yaml.replace(yaml.find(own), own.size(), "");
  yaml.replace(yaml.find(line), line.size(), "do: route, ground_speed_m_s: 0.3");
  const Waypoint of_task = parse_scenario(yaml, "task.yaml").vehicles[0].tasks[0].waypoints[0];
  EXPECT_EQ(of_task.speed_m_s, 0.3);
  EXPECT_EQ(of_task.over_ground, 1);
  const ScenarioVehicle whole_run = with("    model:", "    ground_speed_m_s: 0.2\n    model:");
  EXPECT_EQ(whole_run.speed_m_s, 0.2);
  EXPECT_TRUE(whole_run.is_speed_over_ground);
}

TEST(ReadScenario, TwoVehiclesOfOneNameAreRefused) {
  std::string yaml =
      whole + R"(  - {name: rov, model: x500, start: {north_m: 0, east_m: 0, height_m: 10}}
)";
  EXPECT_THROW((void)parse_scenario(yaml, "bad.yaml"), Error);
}

TEST(ReadScenario, NothingAtThePathIsNotFound) {
  try {
    (void)read_scenario("/nowhere/scenario.yaml");
    FAIL();
  } catch (const Error& problem) {
    EXPECT_EQ(problem.kind(), ErrorKind::not_found);
  }
}

}  // namespace
}  // namespace slackwater::twin::read_scenario_test
