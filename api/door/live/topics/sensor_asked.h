#pragma once
#include <string>
#include <vector>

#include "api/ask/render/sight_choice.h"

namespace slackwater::live {

/// A sensor that is put on a vehicle for the length of a live run.
struct SensorAsked {
  std::string vehicle;  ///< its name in the scenario
  std::string sensor;   ///< of data/sensors
  double rate_hz = 0;   ///< of the run's time
};

/// All that are put on a run's vehicles, and how one sees there.
struct SensorsAsked {
  std::vector<SensorAsked> sensors;
  api::SightChoice sight;
  std::string by;  ///< a detector that looks at pictures of cameras; empty: none
};

/// "rov/rov_camera@2": VEHICLE/SENSOR@RATE.
/// @throws Error(usage)
[[nodiscard]] SensorAsked sensor_asked(const std::string& text);

}  // namespace slackwater::live
