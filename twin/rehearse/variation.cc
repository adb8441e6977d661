#include "twin/rehearse/variation.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/environment/environment.h"
#include "twin/handling/handling_findings.h"

namespace slackwater::twin {
namespace {

/// With all its vehicles on the shelf, so that they can be changed there.
Surround with_shelf(const Scenario& mission, const Surround& surround) {
  Surround out = surround;
  if (out.vehicles.empty()) out.vehicles = read_vehicles(mission, surround.data_folder);
  return out;
}

const Vehicle& vehicle_of(const ScenarioVehicle& entry, const Surround& surround) {
  return *surround.vehicles.at(vehicle_file(entry.model, surround.data_folder));
}

bool has_any(const std::vector<std::string>& wanted, const std::string& found) {
  return wanted.empty() || std::find(wanted.begin(), wanted.end(), found) != wanted.end();
}

/// Where work begins, of the first vehicle that does any.
std::optional<Triple<double>> first_work_of(const Scenario& mission) {
  for (const ScenarioVehicle& vehicle : mission.vehicles)
    for (const ScenarioTask& task : vehicle.tasks)
      if (task.phase == Phase::work && !task.waypoints.empty())
        return task.waypoints.front().position_m;
  return std::nullopt;
}

}  // namespace

std::optional<Variation> at_half_speed(const Scenario& mission, const Surround& surround,
                                       UtcTime start) {
  Variation out{"at half the speed", mission, surround, start};
  bool any = false;
  const auto halve = [&](double& speed_m_s) {
    if (!(speed_m_s > 0)) return;
    speed_m_s *= 0.5;
    any = true;
  };
  for (ScenarioVehicle& vehicle : out.mission.vehicles) {
    if (vehicle.speed_m_s) halve(*vehicle.speed_m_s);
    for (ScenarioTask& task : vehicle.tasks)
      for (Waypoint& waypoint : task.waypoints) halve(waypoint.speed_m_s);
  }
  if (!any) return std::nullopt;
  return out;
}

std::optional<Variation> with_another_battery(const Scenario& mission, const Surround& surround,
                                              UtcTime start) {
  Variation out{"with another battery beside each", mission, with_shelf(mission, surround), start};
  bool any = false;
  for (auto& [file, vehicle] : out.surround.vehicles) {
    if (!vehicle->battery) continue;
    Vehicle changed = *vehicle;
    changed.battery->capacity_c *= 2;
    changed.battery->resistance_ohm /= 2;
    changed.battery->rc_resistance_ohm /= 2;
    changed.battery->rc_capacitance_f *= 2;
    changed.battery->most_current_a *= 2;
    vehicle = std::make_shared<const Vehicle>(std::move(changed));
    any = true;
  }
  if (!any) return std::nullopt;
  return out;
}

std::vector<Variation> with_other_vehicles(const Scenario& mission, const Surround& surround,
                                           UtcTime start, const ExpandedMission& expanded) {
  std::vector<std::string> ids;
  for (const auto& entry : std::filesystem::directory_iterator(surround.data_folder / "vehicles"))
    if (entry.path().extension() == ".yaml") ids.push_back(entry.path().stem().string());
  std::sort(ids.begin(), ids.end());
  const Surround shelf = with_shelf(mission, surround);
  std::vector<Variation> out;
  for (std::size_t i = 0; i < mission.vehicles.size(); ++i) {
    const ScenarioVehicle& entry = mission.vehicles[i];
    const auto asked = std::find_if(expanded.requirements.begin(), expanded.requirements.end(),
                                    [&](const Requirement& r) { return r.agent == entry.name; });
    if (asked == expanded.requirements.end()) continue;
    const auto own = vehicle_file(entry.model, surround.data_folder);
    for (const std::string& id : ids) {
      const auto file = vehicle_file(id, surround.data_folder);
      if (file == own) continue;
      const auto other =
          std::make_shared<const Vehicle>(read_handled_vehicle(file, surround.data_folder));
      if (!has_any(asked->kinds, name_of(other->kind))) continue;
      Variation changed{"with " + other->name + " for " + vehicle_of(entry, shelf).name, mission,
                        shelf, start};
      changed.mission.vehicles[i].model = id;
      changed.surround.vehicles[file] = other;
      out.push_back(std::move(changed));
    }
  }
  return out;
}

std::optional<Variation> from_the_other_tide(const Scenario& mission, const Surround& surround,
                                             UtcTime start) {
  constexpr int quarters = 28;  // 7 hours
  constexpr double slack_m_s = 0.05;
  const auto at_m = first_work_of(mission);
  if (!at_m) return std::nullopt;
  Environment environment;
  environment.field = surround.field;
  environment.origin = origin_of(mission, surround.site);
  environment.epoch = start;
  const EnvironmentSampler sampler(environment);
  const CurrentSample now = sampler.forecast_current(*at_m, 0);
  const double speed_m_s = std::abs(now.velocity_m_s);
  if (!has_value(now.status) || speed_m_s < slack_m_s) return std::nullopt;
  std::optional<int> best;
  double most_against = 0;
  for (int quarter = -quarters; quarter <= quarters; ++quarter) {
    const double from_s = quarter * 900.0;
    const CurrentSample then = sampler.forecast_current(*at_m, from_s);
    if (!has_value(then.status) || std::abs(then.velocity_m_s) < slack_m_s) continue;
    if (!has_value(sampler.forecast_current(*at_m, from_s + mission.duration_s).status)) continue;
    const double against = -(then.velocity_m_s * std::conj(now.velocity_m_s)).real() / speed_m_s;
    if (!(against > most_against)) continue;
    most_against = against;
    best = quarter;
  }
  if (!best) return std::nullopt;
  Variation out{"", mission, surround, start + *best * std::chrono::minutes(15)};
  out.what = "from the other side of the tide, at " + format_utc(out.start).substr(11, 5) + "Z";
  return out;
}

}  // namespace slackwater::twin
