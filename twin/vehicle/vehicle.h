#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

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
  Thruster thruster;  ///< of all its mounts
  std::size_t mounts = 0;
  std::array<Mount, most_mounts> mount{};
  Fins fins;
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
};

[[nodiscard]] inline bool burns_fuel(const Vehicle& vehicle) noexcept {
  return vehicle.thruster.kind == ThrusterKind::drive && vehicle.thruster.drive.fuel_kg_j > 0;
}

/// Reads a vehicle's file. A sixth vehicle is such a file.
/// @param data_folder holds thrusters/ and batteries/
/// Throws Error(invalid_input) with file, line and reason, also for one that capsizes, sinks or
/// stands on its head at rest (balance.h).
[[nodiscard]] Vehicle read_vehicle(const std::filesystem::path& file,
                                   const std::filesystem::path& data_folder);

}  // namespace slackwater::twin
