#include "fields/base/error.h"
#include "twin/inspection/inspection.h"
#include "twin/run/set_up.h"

namespace slackwater::twin {
namespace {

std::shared_ptr<const Inspection> readied(const Scenario& scenario, const ScenarioVehicle& entry,
                                          const std::filesystem::path& data_folder) {
  // Of work that only stays, where it was brought before.
  std::vector<Waypoint> way;
  Waypoint at;
  at.position_m = entry.start_m;
  for (const ScenarioTask& task : entry.tasks) {
    if (task.phase == Phase::work && task.waypoints.empty()) way.push_back(at);
    if (task.phase == Phase::work)
      way.insert(way.end(), task.waypoints.begin(), task.waypoints.end());
    if (!task.waypoints.empty()) at = task.waypoints.back();
  }
  return ready_inspection(entry.name, *entry.conduct->inspection, way, data_folder,
                          scenario.rays_per_look);
}

}  // namespace

InspectionShelf read_inspections(const Scenario& scenario,
                                 const std::filesystem::path& data_folder) {
  InspectionShelf shelf;
  for (const ScenarioVehicle& entry : scenario.vehicles)
    if (entry.conduct && entry.conduct->inspection)
      with_context("vehicle " + entry.name,
                   [&] { shelf[entry.name] = readied(scenario, entry, data_folder); });
  return shelf;
}

std::shared_ptr<const Inspection> inspection_of(const Scenario& scenario,
                                                const ScenarioVehicle& entry,
                                                const Surround& surround) {
  const auto found = surround.inspections.find(entry.name);
  return found != surround.inspections.end() ? found->second
                                             : readied(scenario, entry, surround.data_folder);
}

}  // namespace slackwater::twin
