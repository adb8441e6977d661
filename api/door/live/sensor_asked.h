#pragma once
#include <string>

namespace slackwater::live {

/// A sensor that is put on a vehicle for the length of a live run.
struct SensorAsked {
  std::string vehicle;  ///< its name in the scenario
  std::string sensor;   ///< of data/sensors
  double rate_hz = 0;   ///< of the run's time
};

/// "rov/rov_camera@2": VEHICLE/SENSOR@RATE.
/// @throws Error(usage)
[[nodiscard]] SensorAsked sensor_asked(const std::string& text);

}  // namespace slackwater::live
