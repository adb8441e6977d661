#pragma once
#include <filesystem>
#include <memory>
#include <mutex>
#include <span>

#include "twin/run/set_up.h"

namespace slackwater::twin {

/// Makes vehicles ready for a run that goes on, as they are made ready for its start: by their
/// files, in the same water, keeping clear as the scenario has it, their randomness from (seed,
/// name). Thread-safe, so that files are read and autopilots worked out while the run goes on.
class NewcomerYard {
 public:
  /// @param scenario  outlives it
  /// @param shelf     vehicles that are read already
  /// @param fleet     of the run: what the newcomers share with it
  NewcomerYard(const Scenario& scenario, std::filesystem::path data_folder, VehicleShelf shelf,
               std::span<const Agent> fleet);

  /// The same for the same newcomer and time, to the last bit.
  /// @param t_s  of the run, when it was asked for: the water is looked at, and its gusts begin, as
  ///             they are then
  /// @throws Error(not_found) for a model that is not in the catalogue; Error(invalid_input) for
  ///         numbers that are none and for a place where the vehicle cannot be: outside the
  ///         forecast, on land, below the bed, deeper than it is rated for, in a structure, out of
  ///         its element
  [[nodiscard]] std::shared_ptr<const ReadyNewcomer> ready(const Newcomer& newcomer,
                                                           double t_s) const;

 private:
  [[nodiscard]] std::shared_ptr<const Vehicle> vehicle_of(const std::string& model) const;

  const Scenario& scenario_;
  std::filesystem::path data_folder_;
  std::shared_ptr<const EnvironmentSampler> water_;
  std::shared_ptr<const std::vector<TrafficVessel>> vessels_;
  mutable std::mutex mutex_;  ///< of the shelf
  mutable VehicleShelf shelf_;
};

/// The file of a vehicle of the catalogue by its name alone, of which nothing else is looked up.
/// @throws Error(not_found) that lists the catalogue
[[nodiscard]] std::filesystem::path catalogue_file(const std::string& model,
                                                   const std::filesystem::path& data_folder);

}  // namespace slackwater::twin
