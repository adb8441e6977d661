#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>

#include "tests/support/shared_data.h"
#include "twin/environment/made_up_field.h"
#include "twin/run/run.h"
#include "twin/run/run_log.h"
#include "twin/run/set_up.h"

namespace slackwater::tests {

/// The vehicles of data/, in the made-up water of the scenario.
inline twin::Surround surround_of(const twin::Scenario& scenario) {
  twin::Surround surround;
  surround.data_folder = source_folder() / "data";
  surround.site = twin::origin_of(scenario, {});
  const UtcTime from = scenario.start.value_or(parse_utc("2025-06-02T06:00:00Z"));
  surround.field = twin::made_up_field(std::get<twin::MadeUpWater>(scenario.water), surround.site,
                                       from, from + std::chrono::hours(2));
  return surround;
}

inline twin::ReadyRun ready_of(const std::string& yaml) {
  const twin::Scenario scenario = twin::parse_scenario(yaml, "test.yaml");
  return twin::set_up(scenario, surround_of(scenario));
}

/// The head of a scenario: sheared current of 0.1 to 0.4 m/s in 60 m, wind of 8 m/s from the west.
inline std::string head(double step_s, const std::string& waves = "{from: calm}",
                        const std::string& gusts = "none") {
  return "name: test\nseed: 7\nduration: 30min\nstep_s: " + std::to_string(step_s) +
         "\nlog_every_s: " + std::to_string(10 * step_s) + R"(
water:
  made_up:
    depth_m: 60
    current: [{depth_m: 0, east_m_s: 0.4, north_m_s: 0.1},
              {depth_m: 40, east_m_s: 0.1, north_m_s: -0.1}]
    wind: {speed_m_s: 8, from_deg: 270}
waves: )" +
         waves + "\ngusts: " + gusts + "\nvehicles:\n";
}
/// The same without current and wind.
inline std::string calm_head(double step_s) {
  return "name: test\nseed: 7\nduration: 30min\nstep_s: " + std::to_string(step_s) +
         "\nlog_every_s: " + std::to_string(10 * step_s) +
         "\nwater: {made_up: {depth_m: 60}}\nvehicles:\n";
}

/// Ten ROVs, more than a block holds, the last at a tether; three AUVs; two multirotors; two WAM-Vs
/// and a crew transfer vessel. In current, waves and gusts.
inline std::string mixed_fleet() {
  std::string yaml = head(
      0.05,
      "{partitions: [{significant_height_m: 1, peak_period_s: 6, from_deg: 250}], components: 16}",
      "dryden");
  for (int i = 0; i < 10; ++i) {
    const std::string n = std::to_string(i);
    yaml += "  - {name: rov" + n + ", model: bluerov2_heavy, start: {north_m: " + n +
            ", east_m: 5, depth_m: 1" + n + ", heading_deg: " + std::to_string(36 * i) +
            "}, tasks: [{do: route, waypoints: [{north_m: " + n +
            ", east_m: 5.8, depth_m: 12}, {north_m: 9, east_m: 20, depth_m: 15}]}]";
    yaml +=
        i == 9 ? ", tether: {top: {north_m: 0, east_m: 0, depth_m: 1}, length_m: 40}}\n" : "}\n";
  }
  for (int i = 0; i < 3; ++i) {
    const std::string n = std::to_string(i);
    yaml += "  - {name: auv" + n + ", model: lrauv_tethys, start: {north_m: " + n +
            "00, east_m: 0, depth_m: 1" + n +
            "}, tasks: [{do: hold, duration: 1min}, {do: route, waypoints: [{north_m: " + n +
            "00, east_m: 200, depth_m: 20}]}]}\n";
  }
  for (int i = 0; i < 2; ++i) {
    const std::string n = std::to_string(i);
    yaml += "  - {name: uav" + n + ", model: x500, start: {north_m: " + n +
            "0, east_m: 0, height_m: 3" + n +
            "}, tasks: [{do: route, waypoints: [{north_m: 50, east_m: " + n +
            "0, height_m: 35}]}]}\n";
  }
  for (int i = 0; i < 2; ++i) {
    const std::string n = std::to_string(i);
    yaml += "  - {name: usv" + n + ", model: wamv16, start: {north_m: -" + n +
            "00, east_m: 0, depth_m: 0, heading_deg: " + std::to_string(50 * i) +
            "}, tasks: [{do: route, waypoints: [{north_m: -" + n +
            "00, east_m: 150, depth_m: 0}]}]}\n";
  }
  yaml +=
      "  - {name: ctv, model: ctv24, start: {north_m: -400, east_m: 0, depth_m: 0}, tasks: [{do: "
      "route, waypoints: [{north_m: 600, east_m: 300, depth_m: 0}]}]}\n";
  return yaml;
}

/// The AUVs hold for a second, which no file can say: its shortest time is a minute.
inline twin::ReadyRun mixed_fleet_ready(std::uint64_t seed = 7) {
  twin::Scenario scenario = twin::parse_scenario(mixed_fleet(), "test.yaml");
  scenario.seed = seed;
  for (twin::ScenarioVehicle& vehicle : scenario.vehicles)
    for (twin::ScenarioTask& task : vehicle.tasks) task.hold_s = std::min(task.hold_s, 1.0);
  return twin::set_up(scenario, surround_of(scenario));
}

inline twin::RunSettings settings_of(double step_s) {
  twin::RunSettings settings;
  settings.seed = 7;
  settings.step_s = step_s;
  return settings;
}

/// What was set up, about to begin.
inline std::unique_ptr<twin::Run> begun(twin::ReadyRun ready, double step_s,
                                        std::size_t threads = 1, bool is_batch = true) {
  twin::RunSettings settings = settings_of(step_s);
  settings.threads = threads;
  settings.is_batch = is_batch;
  return std::make_unique<twin::Run>(std::move(ready.agents), std::move(ready.states), settings);
}

inline void step_and_log(twin::Run& run, int steps, twin::RunLog& log) {
  for (int i = 0; i < steps; ++i) {
    run.step();
    log.append(run.time_s(), run.agents(), run.states());
  }
}

/// Bit by bit, so that no number equals another that prints alike.
inline bool same_bits(std::span<const double> a, std::span<const double> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}
inline void expect_same_bits(const twin::RunLog& a, const twin::RunLog& b,
                             const std::string& what) {
  EXPECT_TRUE(same_bits(a.t_s, b.t_s)) << what;
  ASSERT_EQ(a.rows.size(), b.rows.size()) << what;
  for (std::size_t i = 0; i < a.rows.size(); ++i)
    EXPECT_TRUE(same_bits(a.rows[i], b.rows[i])) << what << ": vehicle " << i;
}

}  // namespace slackwater::tests
