#pragma once
#include <filesystem>

#include "fields/base/config.h"
#include "twin/vehicle/vehicle.h"

namespace slackwater::twin {

/// A vehicle by the keys that stood in a file, or would: as `read_vehicle`, for who changes some of
/// them first.
/// @param config  nothing of it was read yet
[[nodiscard]] Vehicle vehicle_of(const Config& config, const std::filesystem::path& data_folder);

}  // namespace slackwater::twin
