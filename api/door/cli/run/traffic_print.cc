#include "api/door/cli/run/traffic_print.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "api/log/traffic_tables.h"

namespace slackwater::api {
namespace {

using nlohmann::json;
using twin::AlarmEnd;
using twin::AlarmRecord;

std::size_t vessels_around(const ScenarioResult& result) {
  std::set<std::uint32_t> ids;
  for (const twin::TrafficVessel& vessel : result.vessels)
    if (vessel.is_around) ids.insert(vessel.id);
  return ids.size();
}

json statistics_json(const twin::DistanceStatistics& s) {
  return {{"mean_m", s.mean_m}, {"rms_m", s.rms_m}, {"most_m", s.most_m}};
}

json name_or_null(const std::string& name) { return name.empty() ? json(nullptr) : json(name); }

json alarm_json(const ScenarioResult& result, const AlarmRecord& alarm) {
  const bool is_over = alarm.end != AlarmEnd::still_on;
  return {{"vehicle", result.account.vehicles[alarm.vehicle].name},
          {"mmsi", alarm.mmsi},
          {"name", name_or_null(name_of_vessel(result.vessels, alarm.mmsi))},
          {"begin_s", alarm.begin_s},
          {"end_s", is_over ? json(alarm.end_s) : json(nullptr)},
          {"end", std::string(name_of(alarm.end))},
          {"cpa_m", alarm.cpa_m},
          {"tcpa_s", alarm.tcpa_s},
          {"least_distance_m", alarm.least_distance_m},
          {"least_distance_s", alarm.least_distance_s}};
}

json followed_json(const TrackFollowing& f) {
  const bool is_known = f.deviation.samples > 0;
  const auto or_null = [&](json value) { return is_known ? std::move(value) : json(nullptr); };
  return {{"vehicle", f.vehicle_name},
          {"task", f.task},
          {"mmsi", f.mmsi},
          {"name", name_or_null(f.name)},
          {"samples", f.deviation.samples},
          {"unknown", f.deviation.unknown},
          {"across", or_null(statistics_json(f.deviation.across))},
          {"along", or_null(statistics_json(f.deviation.along))},
          {"distance", or_null(statistics_json(f.deviation.apart))},
          {"within_m", f.within_m},
          {"share_within", or_null(f.share_within())}};
}

}  // namespace

void print_traffic(const ScenarioResult& result) {
  for (const TrackFollowing& followed : result.followed)
    std::printf("%s\n", text_of(followed).c_str());
  if (result.vessels.empty()) return;
  std::printf("%zu vessels around, %zu alarms\n", vessels_around(result), result.alarms.size());
  if (result.alarms.empty()) return;
  std::printf("%-16s %9s  %-20s %8s %8s %7s %7s %8s  %s\n", "alarm of", "MMSI", "name", "from s",
              "to s", "CPA m", "TCPA s", "least m", "end");
  for (const AlarmRecord& alarm : result.alarms)
    std::printf("%-16s %9u  %-20s %8.0f %8.0f %7.0f %7.0f %8.0f  %s\n",
                result.account.vehicles[alarm.vehicle].name.c_str(), alarm.mmsi,
                name_of_vessel(result.vessels, alarm.mmsi).c_str(), alarm.begin_s, alarm.end_s,
                alarm.cpa_m, alarm.tcpa_s, alarm.least_distance_m,
                std::string(name_of(alarm.end)).c_str());
}

json traffic_json(const ScenarioResult& result) {
  if (result.vessels.empty()) return nullptr;
  json out = {
      {"vessels", vessels_around(result)}, {"alarms", json::array()}, {"followed", json::array()}};
  for (const AlarmRecord& alarm : result.alarms) out["alarms"].push_back(alarm_json(result, alarm));
  for (const TrackFollowing& f : result.followed) out["followed"].push_back(followed_json(f));
  return out;
}

}  // namespace slackwater::api
