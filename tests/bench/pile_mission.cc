#include "tests/bench/pile_mission.h"

#include <sys/resource.h>

#include <cmath>

#include "fields/base/config.h"
#include "fields/base/constants.h"
#include "tests/support/shared_data.h"
#include "tests/twin/mission/mission_for_tests.h"
#include "twin/environment/made_up_field.h"

namespace slackwater::bench {

using namespace twin;

namespace {

constexpr const char* inspection = R"(
id: inspection
name: Inspection of a monopile
agents:
  - role: inspector
    kinds: [rov]
    needs: [depth]
    model: bluerov2_heavy
    speed_m_s: 0.3
    start: {distance_m: 18, depth_m: 3}
    tether: {top: {distance_m: 22, depth_m: 0}, length_m: 90}
    launch_s: 180
    clear_m: 1.5
    conduct:
      reserve: {share: 0.2, margin: 1.3}
      holding: {resume_after_s: 120, overlap_m: 1}
      limits:
        - {significant_wave_height_m: 1.5}
        - {current_speed_m_s: 0.5, phases: [transit, work]}
        - {wind_speed_10m_m_s: 12}
    work:
      - {pattern: verticals, stand_off_m: 1.5, from: {depth_m: 4}, to: {above_bed_m: 2},
         bearings: 16, stops: 3, stop_s: 30}
)";
constexpr const char* mission_yaml = R"(
name: bench
seed: 7
duration: 1h
step_s: 0.05
tasks: [inspection]
turbines: [A01]
water:
  made_up:
    depth_m: 35
    current: [{depth_m: 0, east_m_s: 0.4, north_m_s: 0}]
    wind: {speed_m_s: 5, from_deg: 270}
waves: {partitions: [{significant_height_m: 1, peak_period_s: 6, from_deg: 270}]}
)";

}  // namespace

UtcTime first_start() { return parse_utc("2025-06-02T06:00:00Z"); }

Scenario pile_mission(const std::string& more) {
  WorkSite site = tests::small_farm();
  MissionParts parts;
  parts.site = std::move(site);
  parts.task = [](const std::string&) { return Config::parse(inspection, "inspection.yaml"); };
  const Config mission = Config::parse(mission_yaml + more, "mission.yaml");
  Scenario scenario = expand_mission(mission, parts).scenario;
  scenario.origin = GeoPoint::from_degrees(54, 6.6);
  scenario.has_origin = true;
  return scenario;
}

Surround tidal_water(const Scenario& mission) {
  const std::vector<double> depths_m{0, 5, 10, 15, 20, 30, 35};
  std::vector<UtcTime> times;
  std::vector<Horizontal> current;
  for (int hour = 0; hour <= static_cast<int>(all_starts) + 2; ++hour) {
    times.push_back(first_start() + std::chrono::hours(hour));
    const double tide_m_s = 0.55 * std::cos(2 * constants::pi * hour / 12.42);
    for (const double depth_m : depths_m)
      current.push_back(tide_m_s * Horizontal(1 - depth_m / 60, 0.1));
  }
  Surround surround;
  surround.site = mission.origin;
  surround.data_folder = tests::source_folder() / "data";
  surround.field = made_up_field(times, depths_m, current, {5, 0}, mission.origin, 35);
  return surround;
}

double cpu_seconds() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

Flown flown(const Scenario& mission, std::size_t starts, std::size_t members, int threads) {
  api::RehearsalPlan plan;
  for (std::size_t i = 0; i < starts; ++i)
    plan.starts.push_back(first_start() +
                          std::chrono::hours(static_cast<int>(i * all_starts / starts)));
  plan.members = members;
  plan.threads = threads;
  const Surround surround = tidal_water(mission);
  const double before_s = cpu_seconds();
  const api::Rehearsal rehearsal = api::rehearse(mission, surround, plan);
  Flown out;
  out.cpu_s = cpu_seconds() - before_s;
  out.wall_s = rehearsal.wall_s;
  out.first_answer_s = rehearsal.first_answer_s;
  for (const api::StartOutcome& start : rehearsal.starts) {
    for (const Flight& flight : start.flights) {
      ++out.flights;
      out.flown_s += flight.ended_s;
      const VehicleAccount& outcome = flight.vehicles.front();
      out.energy_j.push_back(outcome.on_mission.drawn_j);
      if (outcome.inspection) {
        out.covered.push_back(outcome.inspection->share());
        out.rays += outcome.inspection->rays;
      }
      const auto is_by = [&](const char* what) {
        return outcome.stopped_by.find(what) != std::string::npos;
      };
      out.none_broke = out.none_broke && (flight.is_done || is_by("out of time") || is_by("limit"));
    }
  }
  return out;
}

}  // namespace slackwater::bench
