#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <vector>

#include "fields/wind/turbine.h"
#include "twin/run/run.h"
#include "twin/scenario/scenario.h"

namespace slackwater::twin {

/// Vehicles by their files.
using VehicleShelf = std::map<std::filesystem::path, std::shared_ptr<const Vehicle>>;
/// What vehicles inspect, by their names.
using InspectionShelf = std::map<std::string, std::shared_ptr<const Inspection>>;

/// What a scenario needs from outside.
struct Surround {
  std::shared_ptr<const Field> field;
  GeoPoint site;                           ///< the origin where the scenario names none
  std::vector<Horizontal> turbines_m;      ///< about the origin
  std::shared_ptr<const Turbine> turbine;  ///< of all of them
  std::filesystem::path data_folder;       ///< vehicles/, thrusters/, batteries/
  std::vector<TrafficVessel> vessels;      ///< of the logs of AIS, on the plane of the origin
  VehicleShelf vehicles;  ///< read already, for many runs of a scenario; others are read
  /// Nothing will be run: a place needs no current where the forecast has none at all.
  bool is_only_asked = false;
  InspectionShelf inspections;  ///< made ready already, for many runs; others are made ready
};

/// A scenario made ready: everything is checked, nothing has moved yet.
struct ReadyRun {
  UtcTime start;
  GeoPoint origin;
  std::shared_ptr<const Environment> environment;
  std::vector<Agent> agents;
  std::vector<AgentState> states;
  std::vector<TrafficVessel> vessels;  ///< of logs and made up
  std::vector<std::string> warnings;
  VehicleShelf vehicles;  ///< what was read for it
};

/// Throws Error(invalid_input) before the first step for what cannot be run: a time or place
/// outside the forecast, currents that are means over hours (unless the scenario accepts them), a
/// start on land, below the bed or in a structure, a way through a structure, an unphysical
/// vehicle.
[[nodiscard]] ReadyRun set_up(const Scenario& scenario, const Surround& surround);

/// The vehicles of a scenario, read. @throws Error(invalid_input) that names the vehicle
[[nodiscard]] VehicleShelf read_vehicles(const Scenario& scenario,
                                         const std::filesystem::path& data_folder);

/// What the vehicles of a scenario inspect, made ready for many runs of it.
/// @throws Error(invalid_input) that names the vehicle
[[nodiscard]] InspectionShelf read_inspections(const Scenario& scenario,
                                               const std::filesystem::path& data_folder);
/// What one of them inspects: from the shelf, or made ready.
[[nodiscard]] std::shared_ptr<const Inspection> inspection_of(const Scenario& scenario,
                                                              const ScenarioVehicle& entry,
                                                              const Surround& surround);

/// The file of a vehicle: data_folder/vehicles/MODEL.yaml, or the path that `model` is.
/// @throws Error(invalid_input) that lists the known ones where there is neither
[[nodiscard]] std::filesystem::path vehicle_file(const std::string& model,
                                                 const std::filesystem::path& data_folder);

/// The vehicles that have a file in data_folder/vehicles, in the order of their names.
[[nodiscard]] std::vector<std::string> catalogue(const std::filesystem::path& data_folder);

/// Gives a vehicle that the wind reaches the gusts of its scenario. @param t_s  when it starts
void add_gusts(const Scenario& scenario, const ScenarioVehicle& entry, double t_s, Agent& agent);

/// The body of a structure of a scenario.
[[nodiscard]] Structure shape_of(const ScenarioStructure& structure);

/// The origin that a scenario will have.
[[nodiscard]] GeoPoint origin_of(const Scenario& scenario, const GeoPoint& site) noexcept;

/// An agent from its parts, for runs that are made without a file.
/// @param barrier_s  the barrier's step; the vehicle's is the largest whole part of it that it
///                   bears, or that of `step_s`
[[nodiscard]] Agent make_agent(std::shared_ptr<const Vehicle> vehicle,
                               std::shared_ptr<const EnvironmentSampler> water,
                               const ScenarioVehicle& entry, double barrier_s);
/// Its state at the start. All randomness comes from (seed, name of the vehicle).
[[nodiscard]] AgentState first_state(const Agent& agent, const ScenarioVehicle& entry,
                                     std::uint64_t seed);

}  // namespace slackwater::twin
