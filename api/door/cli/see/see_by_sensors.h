#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "api/door/cli/command.h"
#include "api/door/live/topics/sensor_asked.h"
#include "twin/scenario/scenario.h"

namespace slackwater::api {

/// `simulate --see`: what looks at a run once its log is there.
struct SeeingAsked {
  std::vector<std::string> sensors;  ///< VEHICLE/SENSOR@RATE
  std::string by;                    ///< a detector of what the cameras saw; empty: none
};
/// @param log  of the run, to be
/// @throws Error(usage) without a log, or for a detector without a camera; Error(not_found),
///         Error(invalid_input) for a vehicle, a sensor or a detector that is not there: before the
///         run is made
[[nodiscard]] std::vector<live::SensorAsked> sensors_to_see(const SeeingAsked& asked,
                                                            const std::filesystem::path& log,
                                                            const twin::Scenario& scenario);

struct SeenLog {
  std::filesystem::path log;
  std::string by;
  std::optional<std::filesystem::path> forecast;  ///< that it ran in, where it is a file
  std::size_t threads = 1;
};
/// What they saw, each in a folder beside the log, LOG-VEHICLE-SENSOR: the files of `render`; and
/// in the log what the detector finds there. Says so, unless JSON is asked for.
/// @return that JSON, one of each
nlohmann::json see_by_sensors(const std::vector<live::SensorAsked>& sensors, const SeenLog& of,
                              const Context& context);

}  // namespace slackwater::api
