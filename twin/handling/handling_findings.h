#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "twin/handling/kept_course.h"
#include "twin/vehicle/balance.h"

namespace slackwater::twin {

/// What is amiss with how a vehicle goes straight ahead at its cruise speed. One that is stable by
/// itself is; one that is not, by its own fins, thrusters and autopilot. A multirotor has none.
///
/// - Its course or its depth is lost (`is_lost`): an error. It says how fast a deviation grows by
///   itself (open_loop.h) and which derivative the file most likely lacks.
/// - They are not kept (`is_kept`): a warning.
[[nodiscard]] std::vector<VehicleFinding> findings_on_handling(const Vehicle& vehicle);

/// `read_vehicle` of one that is to be run: with the warnings above beside its own.
/// Cost: some milliseconds more.
/// @throws Error(invalid_input) as that, and for the errors above, with file and line
[[nodiscard]] Vehicle read_handled_vehicle(const std::filesystem::path& file,
                                           const std::filesystem::path& data_folder);

}  // namespace slackwater::twin
