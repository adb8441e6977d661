#pragma once
#include <filesystem>

#include "fields/base/config.h"
#include "twin/vehicle/vehicle.h"

namespace slackwater::twin {

/// Reads what pushes a vehicle and where: `thruster`, one kind for all mounts, or `thrusters`,
/// kinds with names that the mounts have; and `mounts`.
/// @param data_folder  holds thrusters/
void read_mounts(const Config& config, const std::filesystem::path& data_folder, Vehicle& vehicle);

}  // namespace slackwater::twin
