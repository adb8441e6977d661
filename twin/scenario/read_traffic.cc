#include <algorithm>
#include <cmath>

#include "fields/base/config.h"
#include "fields/base/error.h"
#include "twin/mission/reach.h"
#include "twin/scenario/scenario_traffic.h"
#include "twin/traffic/laid_track.h"

namespace slackwater::twin {
namespace {

constexpr int largest_mmsi = 999'999'999;

std::uint32_t read_mmsi(const Config& config) {
  return static_cast<std::uint32_t>(config.integer("mmsi", 1, largest_mmsi));
}

std::vector<std::uint32_t> read_mmsis(const Config& config) {
  std::vector<std::uint32_t> out;
  for (const double number : config.numbers("mmsi", {1, largest_mmsi})) {
    if (number != std::floor(number)) config.refuse("mmsi", "found a fraction, expected an MMSI");
    out.push_back(static_cast<std::uint32_t>(number));
  }
  return out;
}

/// What logs of the traffic and of a task have in common.
AisLog read_log(const Config& config) {
  AisLog log;
  log.file = config.text("file");
  if (const auto starts = config.optional_text("starts")) {
    try {
      log.starts = parse_utc(*starts);
    } catch (const Error& problem) {
      config.refuse("starts", problem.message());
    }
  }
  return log;
}

MadeUpVessel read_vessel(const Config& config) {
  MadeUpVessel vessel;
  vessel.mmsi = read_mmsi(config);
  vessel.name = config.optional_text("name").value_or("");
  if (vessel.name.size() > 20)
    config.refuse(
        "name", "found " + std::to_string(vessel.name.size()) + " characters, AIS has at most 20");
  vessel.begins_s = config.optional_number("begins_s", {-30 * 86400.0, 30 * 86400.0}).value_or(0);
  std::vector<Triple<double>>& places = vessel.places_m;
  for (const Config& at : config.children("waypoints"))
    places.push_back(
        {at.number("north_m", within_reach_m), at.number("east_m", within_reach_m), 0});
  if (places.empty()) config.refuse("waypoints", "none; give places with north_m and east_m");
  if (places.size() > 1000) config.refuse("waypoints", "found more than 1000");
  if (places.size() > 1 || config.has("speed_m_s"))
    vessel.speed_m_s = config.number("speed_m_s", {0.05, 50});
  return vessel;
}

}  // namespace

TrafficVessel vessel_of(const MadeUpVessel& made_up, double duration_s) {
  TrafficVessel vessel;
  vessel.id = made_up.mmsi;
  vessel.name = made_up.name;
  vessel.track = laid_track(made_up.places_m, made_up.speed_m_s, made_up.begins_s, duration_s);
  return vessel;
}

ScenarioTraffic read_traffic(const Config& scenario) {
  ScenarioTraffic traffic;
  const auto config = scenario.optional_child("traffic");
  if (!config) return traffic;
  for (const Config& log : config->children("ais")) {
    traffic.logs.push_back(read_log(log));
    traffic.logs.back().mmsi = read_mmsis(log);
    if (const auto reach_km = log.optional_number("reach_km", {0.1, 50}))
      traffic.logs.back().reach_m = 1000 * *reach_km;
  }
  for (const Config& vessel : config->children("vessels")) {
    traffic.vessels.push_back(read_vessel(vessel));
    const std::uint32_t id = traffic.vessels.back().mmsi;
    const auto is_same = [&](const MadeUpVessel& other) { return other.mmsi == id; };
    if (std::count_if(traffic.vessels.begin(), traffic.vessels.end(), is_same) > 1)
      vessel.refuse("mmsi",
                    "found " + std::to_string(id) + " twice; give each vessel its own number");
  }
  if (traffic.logs.empty() && traffic.vessels.empty())
    scenario.refuse("traffic", "is empty; give ais logs or vessels, or leave it out");
  if (const auto alarm = config->optional_child("alarm")) {
    if (const auto cpa_m = alarm->optional_number("cpa_m", {1, 20e3}))
      traffic.alarm.distance_m = *cpa_m;
    if (const auto tcpa_min = alarm->optional_number("tcpa_min", {0.1, 120}))
      traffic.alarm.time_s = 60 * *tcpa_min;
  }
  return traffic;
}

TrackToFollow read_track_to_follow(const Config& task) {
  TrackToFollow follow;
  follow.mmsi = read_mmsi(task);
  follow.within_m = task.optional_number("within_m", {0.1, 10e3}).value_or(follow.within_m);
  if (task.has("file")) {
    follow.log = read_log(task);
    follow.log->mmsi = {follow.mmsi};
    follow.log->reach_m = 50e3;
    follow.log->is_around = false;
  } else if (task.has("starts")) {
    task.refuse("starts", "found without a file; set it at the log of the traffic");
  }
  return follow;
}

}  // namespace slackwater::twin
