#include "twin/mission/scenario_text.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "fields/base/text.h"

namespace slackwater::twin {

std::string number_text(double value) {
  return formatted("{:.12g}", std::round(value * 1e6) / 1e6 + 0.0);
}

std::string place_text(const Triple<double>& at_m) {
  return "north_m: " + number_text(at_m.x) + ", east_m: " + number_text(at_m.y) +
         (at_m.z < 0 ? ", height_m: " + number_text(-at_m.z)
                     : ", depth_m: " + number_text(std::max(at_m.z, 0.0)));
}

std::string route_text(std::span<const Waypoint> waypoints, Phase phase, bool drifts) {
  std::string text = "      - {do: route, phase: " + std::string(name_of(phase)) +
                     (drifts ? ", frame: drifting" : "") + ", waypoints: [";
  bool is_first = true;
  for (const Waypoint& at : waypoints) {
    text += (is_first ? "{" : ", {") + place_text(at.position_m);
    if (at.speed_m_s > 0) text += ", speed_m_s: " + number_text(at.speed_m_s);
    text += "}";
    is_first = false;
  }
  return text + "]}\n";
}

std::string hold_text(double duration_s, Phase phase) {
  return "      - {do: hold, phase: " + std::string(name_of(phase)) +
         ", duration_s: " + number_text(duration_s) + "}\n";
}

std::string aboard_text(double duration_s, bool is_swapped, Phase phase) {
  return "      - {do: aboard, phase: " + std::string(name_of(phase)) +
         ", duration_s: " + number_text(duration_s) + (is_swapped ? ", battery: swap" : "") + "}\n";
}

std::string carried_text(double least_s, bool is_swapped) {
  return "      - {do: aboard, phase: transit, until: stand_by" +
         (least_s > 0 ? ", duration_s: " + number_text(least_s) : "") +
         (is_swapped ? ", battery: swap" : "") + "}\n";
}

std::string stand_by_text() { return "      - {do: stand_by, phase: work}\n"; }

std::string merged(const std::optional<Config>& base, const std::optional<Config>& over,
                   const std::set<std::string>& left_out) {
  std::vector<std::pair<std::string, std::string>> entries;
  const auto put = [&](const Config& from) {
    for (const std::string& key : from.keys()) {
      if (left_out.contains(key)) continue;
      const auto same = std::find_if(entries.begin(), entries.end(),
                                     [&](const auto& entry) { return entry.first == key; });
      if (same == entries.end())
        entries.emplace_back(key, from.flow_yaml(key));
      else
        same->second = from.flow_yaml(key);
    }
  };
  if (base) put(*base);
  if (over) put(*over);
  std::string text = "{";
  for (const auto& [key, value] : entries)
    text += (text.size() > 1 ? ", " : "") + key + ": " + value;
  return text + "}";
}

}  // namespace slackwater::twin
