#include "twin/run/newcomer_yard.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/base/check.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/handling/handling_findings.h"
#include "twin/run/expect_places.h"
#include "twin/run/expect_speeds.h"
#include "twin/run/printable.h"

namespace slackwater::twin {
namespace {

/// Of what floats, above and below mean sea level: more than tide and waves lift it.
constexpr double most_off_the_surface_m = 10;

/// It keeps its place until the run ends, or until somebody commands it.
ScenarioVehicle entry_of(const Newcomer& newcomer, const Scenario& scenario) {
  ScenarioVehicle entry;
  entry.name = newcomer.name;
  entry.model = newcomer.model;
  entry.start_m = newcomer.position_m;
  entry.heading_rad = newcomer.heading_rad;
  entry.logs_sensors = scenario.logs_sensors;
  ScenarioTask hold;
  hold.kind = ScenarioTask::Kind::hold;
  hold.hold_s = std::numeric_limits<double>::infinity();
  entry.tasks = {hold};
  return entry;
}

void expect_numbers(const Newcomer& newcomer) {
  const auto& [north, east, down] = newcomer.position_m;
  for (const auto& [name, value] :
       {std::pair{"east", east}, std::pair{"north", north}, std::pair{"down", down}})
    if (!(std::abs(value) <= farthest_from_origin_m))
      refuse(formatted("pose: found {} m {}, expected a number within {:g} m of the origin", value,
                       name, farthest_from_origin_m));
  if (!std::isfinite(newcomer.heading_rad))
    refuse("pose: its orientation is none; send a quaternion of length 1");
}

/// What a scenario's file may leave to whoever writes it, and a stranger's pose may not.
void expect_element(const Newcomer& newcomer, const Vehicle& vehicle) {
  const double down_m = newcomer.position_m.z;
  if (vehicle.body.hull.strips > 0 && std::abs(down_m) > most_off_the_surface_m)
    refuse(
        formatted("pose: found a height of {:g} m, expected 0, or at most {:g} m off mean sea "
                  "level: a {} floats",
                  -down_m, most_off_the_surface_m, vehicle.name));
  if (vehicle.rated_depth_m && down_m > *vehicle.rated_depth_m)
    refuse(
        formatted("pose: found a depth of {:g} m, expected at most the {:g} m that a {} is "
                  "rated for",
                  down_m, *vehicle.rated_depth_m, vehicle.name));
}

}  // namespace

std::filesystem::path catalogue_file(const std::string& model,
                                     const std::filesystem::path& data_folder) {
  const std::vector<std::string> known = catalogue(data_folder);
  if (std::find(known.begin(), known.end(), model) == known.end())
    throw Error(ErrorKind::not_found,
                "model: found '" + printable(model, 64) +
                    "', expected a name of the catalogue: " + joined(known, ", "));
  return data_folder / "vehicles" / (model + ".yaml");
}

NewcomerYard::NewcomerYard(const Scenario& scenario, std::filesystem::path data_folder,
                           VehicleShelf shelf, std::span<const Agent> fleet)
    : scenario_(scenario), data_folder_(std::move(data_folder)), shelf_(std::move(shelf)) {
  expects(!fleet.empty(), "a run has a vehicle");
  water_ = fleet.front().water;
  vessels_ = fleet.front().vessels;
}

std::shared_ptr<const Vehicle> NewcomerYard::vehicle_of(const std::string& model) const {
  const std::filesystem::path file = catalogue_file(model, data_folder_);
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = shelf_.find(file); known != shelf_.end()) return known->second;
  }
  const auto read = std::make_shared<const Vehicle>(read_handled_vehicle(file, data_folder_));
  const std::lock_guard lock(mutex_);
  return shelf_.emplace(file, read).first->second;
}

std::shared_ptr<const ReadyNewcomer> NewcomerYard::ready(const Newcomer& newcomer,
                                                         double t_s) const {
  expect_numbers(newcomer);
  const std::shared_ptr<const Vehicle> vehicle = vehicle_of(newcomer.model);
  expect_element(newcomer, *vehicle);
  const ScenarioVehicle entry = entry_of(newcomer, scenario_);
  auto made = std::make_shared<ReadyNewcomer>();
  Agent& agent = made->agent;
  agent = make_agent(vehicle, water_, entry, scenario_.step_s);
  expect_speeds(entry, agent);
  expect_places(scenario_, entry, agent, t_s);
  add_gusts(scenario_, entry, t_s, agent);
  made->state = first_state(agent, entry, scenario_.seed);
  agent.vessels = vessels_;
  agent.helm.home_after_s = scenario_.home_after_s;
  if (scenario_.clearance)
    agent.clearance = clearance_of(agent, *scenario_.clearance, entry, scenario_.step_s);
  return made;
}

}  // namespace slackwater::twin
