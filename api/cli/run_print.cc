#include "api/cli/run_print.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "api/cli/clearance_print.h"
#include "api/cli/traffic_print.h"
#include "api/rehearse/cleaning_report.h"
#include "api/rehearse/inspection_report.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

json events_json(const VehicleSummary& s) {
  json events = json::array();
  for (const FateEvent& event : s.events)
    events.push_back({{"what", event.what},
                      {"at_s", std::isfinite(event.at_s) ? json(event.at_s) : json(nullptr)}});
  return events;
}

/// "12.3 Wh" of a battery, "0.457 kWh" of what nobody described, "8.1 kg" of fuel.
std::string energy_text(const VehicleSummary& s) {
  if (s.burns_fuel && !s.has_battery) return formatted("{:.1f} kg", s.fuel_kg);
  return s.has_battery ? formatted("{:.1f} Wh", s.energy_wh)
                       : formatted("{:.3f} kWh", s.energy_wh / 1000);
}

json summary_json(const VehicleSummary& s) {
  return {{"name", s.name},
          {"model", s.model},
          {"sailed_m", s.sailed_m},
          {"energy_wh", s.is_electric ? json(s.energy_wh) : json(nullptr)},
          {"state_of_charge", s.has_battery ? json(s.state_of_charge) : json(nullptr)},
          {"least_voltage_v", s.has_battery ? json(s.least_voltage_v) : json(nullptr)},
          {"fuel_kg", s.burns_fuel ? json(s.fuel_kg) : json(nullptr)},
          {"rms_across_track_m", s.rms_across_track_m},
          {"rms_depth_error_m", s.floats ? json(nullptr) : json(s.rms_depth_error_m)},
          {"largest_depth_error_m", s.floats ? json(nullptr) : json(s.largest_depth_error_m)},
          {"largest_roll_deg", s.largest_roll_deg},
          {"largest_pitch_deg", s.largest_pitch_deg},
          {"waypoints", s.waypoints},
          {"tasks_done", s.tasks_done},
          {"tasks", s.tasks},
          {"navigation", s.by_sensors ? "sensors" : "truth"},
          {"navigation_error_m", s.by_sensors ? json(s.navigation_error_m) : json(nullptr)},
          {"rms_navigation_error_m", s.by_sensors ? json(s.rms_navigation_error_m) : json(nullptr)},
          {"cleaning", s.cleaning ? cleaning_json(*s.cleaning) : json(nullptr)},
          {"inspection", s.inspection ? inspection_json(s.inspection->outcome) : json(nullptr)},
          {"fate", s.fate.empty() ? json(nullptr) : json(s.fate)},
          {"events", events_json(s)},
          {"closest", closest_json(s.closest)},
          {"clearance", clearance_json(s)},
          {"halt", s.halt},
          {"halted_at_s", s.halt == "none" ? json(nullptr) : json(s.halted_at_s)}};
}

void print_summary(const ScenarioResult& result, const std::filesystem::path& out) {
  std::printf("%-16s %-16s %9s %11s %7s %9s %13s %10s %8s  %s\n", "vehicle", "model", "sailed m",
              "energy", "charge", "off m rms", "depth m, most", "roll/pitch", "tasks",
              "what befell it");
  for (const VehicleSummary& s : result.vehicles) {
    const std::string energy = energy_text(s);
    const std::string charge = s.has_battery ? formatted("{:.1f} %", 100 * s.state_of_charge) : "-";
    const std::string tasks = formatted("{} of {}", s.tasks_done, s.tasks);
    const std::string depth =
        s.floats ? "-" : formatted("{:.2f}, {:.2f}", s.rms_depth_error_m, s.largest_depth_error_m);
    const std::string tilt =
        formatted("{:.0f}/{:.0f} deg", s.largest_roll_deg, s.largest_pitch_deg);
    std::printf("%-16s %-16s %9.1f %11s %7s %9.2f %13s %10s %8s  %s\n", s.name.c_str(),
                s.model.c_str(), s.sailed_m, energy.c_str(), charge.c_str(), s.rms_across_track_m,
                depth.c_str(), tilt.c_str(), tasks.c_str(), s.fate.empty() ? "-" : s.fate.c_str());
  }
  for (const VehicleSummary& s : result.vehicles) {
    if (!s.by_sensors) continue;
    std::printf("%s took itself to be %.2f m from where it was at the end, %.2f m rms\n",
                s.name.c_str(), s.navigation_error_m, s.rms_navigation_error_m);
  }
  for (const VehicleSummary& s : result.vehicles) {
    if (s.cleaning) std::printf("%s: %s\n", s.name.c_str(), cleaning_text(*s.cleaning).c_str());
    if (s.inspection)
      std::printf("%s: %s\n", s.name.c_str(), inspection_text(s.inspection->outcome).c_str());
  }
  std::printf("%g s from %s in %.2f s (%.0f x real time)%s%s\n", result.duration_s,
              format_utc(result.start).c_str(), result.wall_s, result.duration_s / result.wall_s,
              out.empty() ? "" : "; log ", out.c_str());
}

}  // namespace

void print_run(const ScenarioResult& result, const std::filesystem::path& out) {
  print_summary(result, out);
  print_clearance(result);
  print_traffic(result);
}

json run_json(const ScenarioResult& result, const std::string& scenario, const ScenarioWater& water,
              const std::filesystem::path& out) {
  json document = {{"scenario", scenario},
                   {"start", format_utc(result.start)},
                   {"duration_s", result.duration_s},
                   {"wall_s", result.wall_s},
                   {"forecast", water.forecast_name},
                   {"forecast_sha256",
                    water.forecast_sha256.empty() ? json(nullptr) : json(water.forecast_sha256)},
                   {"log", out.empty() ? json(nullptr) : json(out.string())},
                   {"warnings", result.warnings},
                   {"vehicles", json::array()}};
  for (const VehicleSummary& s : result.vehicles) document["vehicles"].push_back(summary_json(s));
  document["traffic"] = traffic_json(result);
  return document;
}

}  // namespace slackwater::api
