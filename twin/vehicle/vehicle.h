#pragma once
#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fields/base/key_places.h"
#include "twin/battery/battery.h"
#include "twin/body/actuators.h"
#include "twin/body/body.h"
#include "twin/control/autopilot_settings.h"
#include "twin/sensor/read_sensors.h"
#include "twin/tether/tether.h"
#include "twin/thruster/thruster.h"

namespace slackwater::twin {

/// A vehicle as its YAML file describes it: loaded once, never changed.
struct Vehicle {
  std::string id;
  std::string name;
  VehicleKind kind = VehicleKind::rov;
  double largest_step_s = 0;
  Body body;
  std::vector<Thruster> thrusters;  ///< the kinds that its mounts have; one at least
  std::size_t mounts = 0;
  std::array<Mount, most_mounts> mount{};
  FinPair rudder;
  FinPair elevator;
  Trim trim;
  Triple<double> wind_force_n_s2_m2;  ///< per square of the relative wind, along each axis
  double wind_yaw_n_m_s2_m2 = 0;   ///< yaw moment per the product of its components along x and y
  double wind_height_m = 10;       ///< above the sea, of the wind that these coefficients are for
  std::optional<Battery> battery;  ///< nothing: fuel
  double hotel_w = 0;
  double cruise_speed_m_s = 0;          ///< where nobody says otherwise
  std::optional<double> rated_depth_m;  ///< no deeper; absent: nobody says
  AutopilotSettings autopilot;
  std::optional<Tether> tether;
  Sensors sensors;
  std::vector<std::string> warnings;  ///< of how it lies in the water; see balance.h
  KeyPlaces places;                   ///< of the keys of its file

  /// "FILE:LINE" of a key, `rudder.area_m2`, for what is found amiss with it later.
  [[nodiscard]] std::string place_of(std::string_view key) const { return places.of(key); }
};

/// What stands at a mount.
[[nodiscard]] inline const Thruster& thruster_of(const Vehicle& vehicle,
                                                 const Mount& mount) noexcept {
  return vehicle.thrusters[mount.kind];
}
[[nodiscard]] inline const Thruster& thruster_of(const Vehicle& vehicle,
                                                 std::size_t mount) noexcept {
  return thruster_of(vehicle, vehicle.mount[mount]);
}
/// How many of its mounts have the thruster of a kind.
[[nodiscard]] inline std::size_t mounts_of_kind(const Vehicle& vehicle, std::size_t kind) noexcept {
  const auto end = vehicle.mount.begin() + static_cast<std::ptrdiff_t>(vehicle.mounts);
  return static_cast<std::size_t>(std::count_if(
      vehicle.mount.begin(), end, [&](const Mount& mount) { return mount.kind == kind; }));
}

[[nodiscard]] inline bool burns_fuel(const Vehicle& vehicle) noexcept {
  return std::any_of(vehicle.thrusters.begin(), vehicle.thrusters.end(), [](const Thruster& t) {
    return t.kind == ThrusterKind::drive && t.drive.fuel_kg_j > 0;
  });
}

[[nodiscard]] inline bool has_fins(const Vehicle& vehicle) noexcept {
  return vehicle.rudder.area_m2 > 0 || vehicle.elevator.area_m2 > 0;
}

/// Reads a vehicle's file. A sixth vehicle is such a file.
/// @param data_folder holds thrusters/ and batteries/
/// Throws Error(invalid_input) with file, line and reason, also for one that capsizes, sinks or
/// stands on its head at rest (balance.h).
[[nodiscard]] Vehicle read_vehicle(const std::filesystem::path& file,
                                   const std::filesystem::path& data_folder);

}  // namespace slackwater::twin
