#include "api/door/cli/run/run_print.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "api/door/cli/run/clearance_print.h"
#include "api/door/cli/run/traffic_print.h"
#include "api/show/rehearse/account_json.h"
#include "api/show/rehearse/cleaning_report.h"
#include "api/show/rehearse/inspection_report.h"
#include "api/show/rehearse/manoeuvre_report.h"
#include "fields/base/constants.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

/// "12.3 Wh" of a battery, "0.457 kWh" of what nobody described, "8.1 kg" of fuel.
std::string energy_text(const twin::VehicleAccount& v) {
  const double energy_wh = v.in_all.drawn_j / 3600;
  if (v.makeup.has_battery) return formatted("{:.1f} Wh", energy_wh);
  return v.makeup.burns_fuel ? formatted("{:.1f} kg", v.in_all.fuel_kg)
                             : formatted("{:.3f} kWh", energy_wh / 1000);
}

void print_summary(const ScenarioResult& result, const std::filesystem::path& out) {
  std::printf("%-16s %-16s %9s %11s %7s %9s %13s %10s %8s  %s\n", "vehicle", "model", "sailed m",
              "energy", "charge", "off m rms", "depth m, most", "roll/pitch", "tasks",
              "what befell it");
  const twin::RunAccount& account = result.account;
  for (const twin::VehicleAccount& v : account.vehicles) {
    const twin::TrackAccount& track = v.track;
    const std::string energy = energy_text(v);
    const std::string charge =
        v.makeup.has_battery ? formatted("{:.1f} %", 100 * v.in_all.charge) : "-";
    const std::string tasks = formatted("{} of {}", v.tasks_done, v.tasks);
    const double deepest_m = magnitude_of(track.depth_error_m);
    const std::string depth =
        v.makeup.floats ? "-" : formatted("{:.2f}, {:.2f}", track.rms_depth_error_m, deepest_m);
    const std::string tilt = formatted("{:.0f}/{:.0f} deg", v.largest_roll_rad / constants::degree,
                                       v.largest_pitch_rad / constants::degree);
    const std::string fate = v.fate.empty() ? "-" : v.fate_text(account.start);
    std::printf("%-16s %-16s %9.1f %11s %7s %9.2f %13s %10s %8s  %s\n", v.name.c_str(),
                v.model.c_str(), track.sailed_m, energy.c_str(), charge.c_str(), track.rms_across_m,
                depth.c_str(), tilt.c_str(), tasks.c_str(), fate.c_str());
  }
  for (const twin::VehicleAccount& v : account.vehicles)
    if (v.makeup.by_sensors)
      std::printf("%s took itself to be %.2f m from where it was at the end, %.2f m rms\n",
                  v.name.c_str(), v.track.navigation_error_m.value_or(0),
                  v.track.rms_navigation_error_m.value_or(0));
  for (const twin::VehicleAccount& v : account.vehicles) {
    if (v.cleaning) std::printf("%s: %s\n", v.name.c_str(), cleaning_text(*v.cleaning).c_str());
    if (v.inspection)
      std::printf("%s: %s\n", v.name.c_str(), inspection_text(*v.inspection).c_str());
    for (const twin::ManoeuvreAccount& one : v.manoeuvres)
      std::printf("%s: %s: %s\n", v.name.c_str(), manoeuvre_name(one).c_str(),
                  manoeuvre_text(one).c_str());
  }
  std::printf("%g s from %s in %.2f s (%.0f x real time)%s%s\n", account.ran_s,
              format_utc(account.start).c_str(), result.wall_s, account.ran_s / result.wall_s,
              out.empty() ? "" : "; log ", out.c_str());
}

}  // namespace

void print_notes(const std::vector<std::string>& notes) {
  for (const std::string& note : notes)
    std::fprintf(stderr, "slackwater: note: %s\n", note.c_str());
}

void print_run(const ScenarioResult& result, const std::filesystem::path& out) {
  print_summary(result, out);
  print_clearance(result.account);
  print_traffic(result);
}

json run_json(const ScenarioResult& result, const std::string& scenario, const ScenarioWater& water,
              const std::filesystem::path& out) {
  json document = {{"scenario", scenario},
                   {"start", format_utc(result.account.start)},
                   {"duration_s", result.account.ran_s},
                   {"wall_s", result.wall_s},
                   {"forecast", water.forecast_name},
                   {"forecast_sha256",
                    water.forecast_sha256.empty() ? json(nullptr) : json(water.forecast_sha256)},
                   {"log", out.empty() ? json(nullptr) : json(out.string())},
                   {"warnings", result.warnings},
                   {"notes", result.notes},
                   {"vehicles", json::array()}};
  for (const twin::VehicleAccount& vehicle : result.account.vehicles)
    document["vehicles"].push_back(account_json(vehicle, result.account.start));
  document["traffic"] = traffic_json(result);
  return document;
}

}  // namespace slackwater::api
