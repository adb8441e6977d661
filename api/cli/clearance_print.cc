#include "api/cli/clearance_print.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

json name_or_null(const std::string& name) { return name.empty() ? json(nullptr) : json(name); }

json approach_json(const std::optional<Approach>& approach) {
  if (!approach) return nullptr;
  json out{{"distance_m", approach->distance_m},
           {"at_s", approach->t_s},
           {"name", name_or_null(approach->to)}};
  if (approach->mmsi != 0) out["mmsi"] = approach->mmsi;
  return out;
}

std::string clock_text(UtcTime start, double t_s) {
  constexpr std::size_t time_of_day = 11;  // behind 2025-06-01T
  const auto whole = Duration(static_cast<Duration::rep>(std::floor(t_s)) * 1000);
  return format_utc(start + whole).substr(time_of_day, 8) + "Z";
}

/// "closest to a vehicle 3.2 m (guard, 06:12:10Z), a structure 12.0 m (pile, 06:10:00Z)".
std::string closest_text(const Closest& closest, UtcTime start) {
  std::vector<std::string> parts;
  const auto add = [&](const char* what, const std::optional<Approach>& approach) {
    if (!approach) return;
    const std::string who = approach->to.empty() ? std::to_string(approach->mmsi) : approach->to;
    parts.push_back(formatted("{} {:.1f} m ({}, {})", what, approach->distance_m, who,
                              clock_text(start, approach->t_s)));
  };
  add("a vehicle", closest.vehicle);
  add("a structure", closest.structure);
  add("a vessel", closest.vessel);
  add("a tether", closest.tether);
  return parts.empty() ? std::string() : "closest to " + joined(parts, ", ");
}

}  // namespace

void print_clearance(const ScenarioResult& result) {
  for (const VehicleSummary& s : result.vehicles) {
    std::vector<std::string> parts;
    if (std::string text = closest_text(s.closest, result.start); !text.empty())
      parts.push_back(std::move(text));
    if (s.clearance) {
      parts.push_back("clearance alarms: " + clearance_alarms_text(s.clearance->alarms_from));
      if (s.clearance->changed_s > 0)
        parts.push_back(formatted("made to keep clear for {:.0f} s", s.clearance->changed_s));
    }
    if (!parts.empty()) std::printf("%s: %s\n", s.name.c_str(), joined(parts, "; ").c_str());
  }
}

json closest_json(const Closest& closest) {
  if (closest == Closest{}) return nullptr;
  return {{"vehicle", approach_json(closest.vehicle)},
          {"structure", approach_json(closest.structure)},
          {"vessel", approach_json(closest.vessel)},
          {"tether", approach_json(closest.tether)}};
}

json clearance_json(const VehicleSummary& vehicle) {
  if (!vehicle.clearance) return nullptr;
  json from = json::object();
  for (std::size_t c = 0; c < twin::alarm_causes; ++c)
    from[twin::name_of(static_cast<twin::AlarmCause>(c))] = vehicle.clearance->alarms_from[c];
  return {{"alarms", vehicle.clearance->alarms},
          {"alarms_from", from},
          {"changed_s", vehicle.clearance->changed_s}};
}

}  // namespace slackwater::api
