#include "api/ask/run/log_file.h"

#include <map>

#include "api/log/account_tables.h"
#include "api/log/action_tables.h"
#include "api/log/command_tables.h"
#include "api/log/inspection_log.h"
#include "api/log/traffic_tables.h"
#include "api/program/version.h"
#include "fields/base/encode/sha256.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using ingest::TrajectoryFile;
using ingest::TrajectoryTable;

/// Positions in degrees on the plane that the run was sampled on.
void add_places(const GeoPoint& origin, const twin::RunLog& log, std::size_t vehicles,
                TrajectoryFile& file) {
  const twin::DegreesPerMetre per_m = twin::degrees_per_metre(origin);
  TrajectoryFile::Variable latitude{"latitude", "latitude", "degrees_north", "latitude", 1, {}};
  TrajectoryFile::Variable longitude{"longitude", "longitude", "degrees_east", "longitude", 1, {}};
  TrajectoryFile::Variable altitude{"altitude", "altitude", "m", "height above mean sea level",
                                    1,          {}};
  for (std::size_t i = 0; i < vehicles; ++i) {
    for (const double y : log.column(i, "y"))
      latitude.values.push_back(origin.latitude_deg() + y * per_m.north);
    for (const double x : log.column(i, "x"))
      longitude.values.push_back(normalised_longitude_deg(origin.longitude_deg() + x * per_m.east));
    for (const double z : log.column(i, "z")) altitude.values.push_back(z);
  }
  for (auto* variable : {&latitude, &longitude, &altitude})
    file.variables.push_back(std::move(*variable));
}

}  // namespace

std::string vehicle_checksums(const twin::Scenario& scenario,
                              const std::filesystem::path& data_folder,
                              std::span<const twin::Command> commands) {
  std::map<std::string, std::string> sums;
  for (const twin::ScenarioVehicle& vehicle : scenario.vehicles) {
    sums[vehicle.model] = sha256_of_file(twin::vehicle_file(vehicle.model, data_folder));
  }
  for (const twin::Command& command : commands)
    if (const auto* spawn = std::get_if<twin::Spawn>(&command.what)) {
      const std::string& model = spawn->newcomer.model;
      sums[model] = sha256_of_file(twin::catalogue_file(model, data_folder));
    }
  std::string text;
  for (const auto& [model, sum] : sums) text += (text.empty() ? "" : ", ") + model + " " + sum;
  return text;
}

TrajectoryFile log_file_of(const twin::Scenario& scenario, const ScenarioWater& water,
                           const GeoPoint& origin, const ScenarioResult& result,
                           std::span<const twin::Agent> agents) {
  TrajectoryFile file;
  for (const twin::Agent& agent : agents) file.names.push_back(agent.name);
  file.epoch = result.account.start;
  file.t_s = result.log.t_s;
  add_places(origin, result.log, agents.size(), file);
  for (const twin::LogVariable& column : twin::log_variables()) {
    TrajectoryFile::Variable variable{column.name,      column.standard_name, column.units,
                                      column.long_name, column.per,           {}};
    for (std::size_t i = 0; i < agents.size(); ++i) {
      const std::vector<double> values = result.log.column(i, column.name);
      variable.values.insert(variable.values.end(), values.begin(), values.end());
    }
    file.variables.push_back(std::move(variable));
  }
  for (const twin::LogVariable& column : result.sensed.columns()) {
    TrajectoryFile::Variable variable{column.name,      column.standard_name, column.units,
                                      column.long_name, column.per,           {}};
    for (std::size_t i = 0; i < agents.size(); ++i) {
      const std::vector<double> values = result.sensed.column(i, column.name);
      variable.values.insert(variable.values.end(), values.begin(), values.end());
    }
    file.variables.push_back(std::move(variable));
  }
  std::string models;
  for (const twin::Agent& agent : agents)
    models += (models.empty() ? "" : ", ") + agent.name + ": " + agent.vehicle->id;
  const Snapshot& snapshot = water.surround.field->snapshot();
  file.attributes = {
      {"title", scenario.name},
      {"source", "slackwater " + code_version()},
      {"log_format", std::to_string(twin::log_format)},
      {"vehicles", models},
      {"vehicle_files_sha256",
       vehicle_checksums(scenario, water.surround.data_folder, result.commands)},
      {"seed", std::to_string(scenario.seed)},
      {"member", std::to_string(scenario.member)},
      {"origin", formatted("{:.9f} N, {:.9f} E", origin.latitude_deg(), origin.longitude_deg())},
      {"forecast", water.forecast_name},
      {"forecast_sha256", water.forecast_sha256},
      {"attribution", joined(snapshot.attributions, "; ")},
      {"scenario", scenario.yaml}};
  if (!water.traffic_files.empty())
    file.attributes.emplace_back("traffic_files_sha256", water.traffic_files);
  if (result.stopped_at_step)
    file.attributes.emplace_back("stopped_at_step", std::to_string(*result.stopped_at_step));
  std::string deviations;
  for (const TrackFollowing& followed : result.followed)
    deviations += (deviations.empty() ? "" : "\n") + text_of(followed);
  if (!deviations.empty()) file.attributes.emplace_back("track_deviation", deviations);
  return file;
}

void add_tables(const twin::Scenario& scenario, ScenarioResult& result) {
  std::vector<TrajectoryTable>& tables = result.file.tables;
  const auto add = [&](std::vector<TrajectoryTable> more) {
    for (TrajectoryTable& table : more) tables.push_back(std::move(table));
  };
  add(traffic_tables(result.vessels, result.alarms));
  add(account_tables(result.account));
  add_inspections(result.inspected, result.file);
  add(command_tables(result.commands, result.refusals, scenario.step_s));
  add(action_tables(result.actions));
}

}  // namespace slackwater::api
